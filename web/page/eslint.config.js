import js from "@eslint/js";
import svelte from "eslint-plugin-svelte";
import globals from "globals";
import ts from "typescript-eslint";
import svelteConfig from "./svelte.config.js";

export default ts.config(
  { ignores: ["dist/", "src/wasm/", "src/generated/"] },
  js.configs.recommended,
  ...ts.configs.recommended,
  ...svelte.configs["flat/recommended"],
  { languageOptions: { globals: globals.browser } },
  {
    files: ["**/*.svelte", "**/*.svelte.ts"],
    languageOptions: { parserOptions: { parser: ts.parser, svelteConfig } },
  },
  {
    rules: {
      // TypeScript knows which names exist; the rule does not.
      "no-undef": "off",
      // Only engine/ may import the WebAssembly modules: no arithmetic of estimators elsewhere.
      "no-restricted-imports": ["error", { patterns: ["**/wasm/*"] }],
    },
  },
  { files: ["src/engine/**"], rules: { "no-restricted-imports": "off" } },
);
