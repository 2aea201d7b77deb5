// Builds the page to one file, dist/template.html, into which `perimpact report` puts the data. The file tells which sources it was built from:
// tests/quality/report_template.py compares them.
import { createHash } from "node:crypto";
import { readFileSync, readdirSync, renameSync } from "node:fs";
import { defineConfig, type Plugin } from "vite";
import { viteSingleFile } from "vite-plugin-singlefile";

function hashOfSources(): string {
  const files = ["index.html", "package-lock.json", "package.json", "tsconfig.json", "vite.config.ts", ...readdirSync("src").map((name) => `src/${name}`)].sort();
  const hash = createHash("sha256");
  for (const file of files) hash.update(`${file}\n`).update(readFileSync(file));
  return hash.digest("hex");
}

const signed: Plugin = {
  name: "signed",
  transformIndexHtml: () => [{ tag: "meta", attrs: { name: "sources", content: hashOfSources() }, injectTo: "head" }],
  closeBundle: () => renameSync("dist/index.html", "dist/template.html"),
};

export default defineConfig({
  plugins: [viteSingleFile({ removeViteModuleLoader: true }), signed],
  esbuild: { legalComments: "inline" },
  build: { target: "es2022", modulePreload: false, reportCompressedSize: false },
});
