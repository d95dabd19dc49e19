#include "beadmesh/read/cad_step_parts.h"

#include <Interface_InterfaceModel.hxx>
#include <Quantity_Color.hxx>
#include <STEPConstruct_Styles.hxx>
#include <StepBasic_Product.hxx>
#include <StepBasic_ProductDefinition.hxx>
#include <StepBasic_ProductDefinitionFormation.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepVisual_Colour.hxx>
#include <StepVisual_StyledItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopTools_MapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Iterator.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <map>
#include <optional>
#include <string>

namespace beadmesh {
namespace {

using Colour = std::array<double, 3>;

std::string text_of(const Handle(TCollection_HAsciiString) & text) {
  return text.IsNull() ? std::string() : text->ToCString();
}

class PartLister {
 public:
  PartLister(const Handle(XSControl_WorkSession) & session, CadModel& model)
      : session_(session), transfer_(session->TransferReader()), model_(model) {
    name_products();
    name_colours();
  }

  void list(const TopoDS_Shape& shape) {
    walk(shape, no_index);
    if (model_.parts.size() < 2) return;
    std::map<std::string, int> used;
    for (PanelPart& part : model_.parts)
      if (const int count = ++used[part.name]; count > 1) part.name += " (" + std::to_string(count) + ")";
  }

 private:
  /// Shapes of products and of their bodies, without their places.
  static TopoDS_Shape bare(const TopoDS_Shape& shape) {
    return shape.Located(TopLoc_Location()).Oriented(TopAbs_FORWARD);
  }

  void name_products() {
    const Handle(Interface_InterfaceModel) file = session_->Model();
    for (int i = 1; i <= file->NbEntities(); ++i) {
      const auto definition = Handle(StepBasic_ProductDefinition)::DownCast(file->Value(i));
      if (definition.IsNull() || definition->Formation().IsNull()) continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(transfer_->TransientProcess(), definition);
      if (shape.IsNull()) continue;
      const Handle(StepBasic_Product) product = definition->Formation()->OfProduct();
      if (products_.Bind(bare(shape), static_cast<int>(names_.size())))
        names_.push_back(product.IsNull() ? std::string() : text_of(product->Name()));
    }
  }

  void name_colours() {
    STEPConstruct_Styles styles(session_);
    if (!styles.LoadStyles()) return;
    for (int i = 1; i <= styles.NbStyles(); ++i) {
      const Handle(StepVisual_StyledItem) style = styles.Style(i);
      if (style.IsNull() || style->Item().IsNull()) continue;
      Handle(StepVisual_Colour) surface, border, curve, rendered;
      double transparency = 0;
      bool is_component = false;
      if (!styles.GetColors(style, surface, border, curve, rendered, transparency, is_component)) continue;
      Quantity_Color colour;
      if (surface.IsNull()) surface = rendered;
      if (surface.IsNull() || !STEPConstruct_Styles::DecodeColor(surface, colour)) continue;
      const TopoDS_Shape shape = TransferBRep::ShapeResult(transfer_->TransientProcess(), style->Item());
      if (shape.IsNull() || !coloured_.Bind(bare(shape), static_cast<int>(colours_.size()))) continue;
      double red, green, blue;
      colour.Values(red, green, blue, Quantity_TOC_sRGB);
      colours_.push_back({red, green, blue});
    }
  }

  /// In the order of TopExp_Explorer.
  void walk(const TopoDS_Shape& shape, Index part) {
    if (products_.IsBound(bare(shape)) && !has_product_inside(shape)) {
      part = static_cast<Index>(model_.parts.size());
      model_.parts.push_back({names_[products_.Find(bare(shape))], 0, {}});
    }
    if (part != no_index && !model_.parts[part].colour && coloured_.IsBound(bare(shape)))
      model_.parts[part].colour = colours_[coloured_.Find(bare(shape))];
    if (shape.ShapeType() == TopAbs_FACE) {
      if (!seen_.Add(shape)) return;
      model_.faces.push_back(TopoDS::Face(shape));
      model_.names.push_back(name_of(model_.faces.back()));
      model_.numbers.push_back(static_cast<Index>(model_.faces.size()));
      model_.part_of_face.push_back(part);
      return;
    }
    for (TopoDS_Iterator at(shape); at.More(); at.Next()) walk(at.Value(), part);
  }

  bool has_product_inside(const TopoDS_Shape& shape) const {
    if (shape.ShapeType() != TopAbs_COMPOUND) return false;
    for (TopoDS_Iterator at(shape); at.More(); at.Next())
      if (products_.IsBound(bare(at.Value())) || has_product_inside(at.Value())) return true;
    return false;
  }

  std::string name_of(const TopoDS_Face& face) const {
    const auto item =
        Handle(StepRepr_RepresentationItem)::DownCast(transfer_->EntityFromShapeResult(face, 1));
    const std::string name = item.IsNull() ? std::string() : text_of(item->Name());
    return name == "NONE" ? std::string() : name;
  }

  Handle(XSControl_WorkSession) session_;
  Handle(XSControl_TransferReader) transfer_;
  CadModel& model_;
  TopTools_DataMapOfShapeInteger products_, coloured_;  // to names_ and colours_
  std::vector<std::string> names_;
  std::vector<Colour> colours_;
  TopTools_MapOfShape seen_;
};

}  // namespace

void list_step_faces(const TopoDS_Shape& shape, const Handle(XSControl_WorkSession) & session,
                     CadModel& model) {
  PartLister(session, model).list(shape);
}

}  // namespace beadmesh
