import { builtinModules } from 'node:module';
import { defineConfig, mergeConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';
import { leftToHost, readManifest } from '../tools/publishedPackages.mjs';

const isOfHost = leftToHost(readManifest(import.meta.dirname));

const banner = ({ name }: { name: string }): string => (name === 'cli' ? '#!/usr/bin/env node' : '');

/** The published bundle, for Node: dependencies and Node's own modules stay imports. */
export default defineConfig(
  // the first line of the command (shebang); declaration files may not begin with one
  mergeConfig(libraryConfig(new URL('.', import.meta.url), { banner }), {
    build: {
      ssr: true,
      rolldownOptions: {
        external: (id: string) => id.startsWith('node:') || builtinModules.includes(id) || isOfHost(id),
      },
    },
  }),
);
