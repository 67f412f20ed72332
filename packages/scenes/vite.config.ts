import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

/** The published package: one file per module, so that a page fetches only the scene that it shows. */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), { preserveModules: true, preserveModulesRoot: 'src' }),
);
