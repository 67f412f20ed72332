import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

/** The published bundle: one ES module, three left to the host. */
export default defineConfig(libraryConfig(new URL('.', import.meta.url)));
