import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

/** The published bundle: one ES module; three and the other packages of Farol are peer dependencies. */
export default defineConfig(libraryConfig(new URL('.', import.meta.url)));
