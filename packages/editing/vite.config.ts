import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

/** The published package: one file per module, so that an app loads only what it uses; three is a peer dependency. */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), { preserveModules: true, preserveModulesRoot: 'src' }),
);
