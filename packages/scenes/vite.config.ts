import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

/** The published package: a file for each module, so that a page fetches the scene that it shows alone. */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), { preserveModules: true, preserveModulesRoot: 'src' }),
);
