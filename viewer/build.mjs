// npm run build: bundles the viewer into viewer/dist. The result is committed, so that a build of the program needs no
// npm; `npm run check` (and a test) makes it again and compares.
import {readFileSync, writeFileSync, mkdirSync} from "node:fs";
import {dirname, join} from "node:path";
import {fileURLToPath} from "node:url";
import {build} from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const modules = join(here, "..", "node_modules");

/** The licences of what is bundled ask for their text. */
function legal() {
  const parts = ["three", "fflate"].map((name) => {
    const {version} = JSON.parse(readFileSync(join(modules, name, "package.json"), "utf8"));
    const text = readFileSync(join(modules, name, "LICENSE"), "utf8").trim();
    return `${name} ${version}\n${text}`;
  });
  const text = ["beadmesh viewer. Licence: Apache-2.0. It holds parts of:", ...parts].join("\n\n");
  return `/*!\n${text.replaceAll("*/", "* /")}\n*/`;
}

async function bundle(entry, extra) {
  const result = await build({
    absWorkingDir: here,
    entryPoints: [join("src", entry)],
    bundle: true,
    minify: true,
    charset: "utf8",
    legalComments: "none",
    target: ["es2022"],
    write: false,
    logLevel: "warning",
    ...extra,
  });
  return result.outputFiles[0].text;
}

/** Texts of the files of viewer/dist. */
export async function bundles() {
  return {
    "viewer.js": await bundle("main.js", {format: "iife", banner: {js: legal()}}),
    "viewer.css": await bundle("style.css", {}),
  };
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const check = process.argv.includes("--check");
  mkdirSync(join(here, "dist"), {recursive: true});
  let same = true;
  for (const [name, text] of Object.entries(await bundles())) {
    const path = join(here, "dist", name);
    if (!check) {
      writeFileSync(path, text);
    } else if (readFileSync(path, "utf8") !== text) {
      console.error(`viewer/dist/${name} is not what viewer/src makes: run npm run build`);
      same = false;
    }
  }
  process.exitCode = same ? 0 : 1;
}
