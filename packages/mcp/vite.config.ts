import { builtinModules } from 'node:module';
import { defineConfig, mergeConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';
import { leftToHost, readManifest } from '../tools/publishedPackages.mjs';

const isOfHost = leftToHost(readManifest(import.meta.dirname));

const postBanner = ({ name }: { name: string }): string => (name === 'cli' ? '#!/usr/bin/env node' : '');

/** The published bundle, for Node: dependencies and Node's own modules are left to the host. */
export default defineConfig(
  // the command's first line, which shells run it by; declarations may not begin with one
  mergeConfig(libraryConfig(new URL('.', import.meta.url), { postBanner }), {
    build: {
      ssr: true,
      rolldownOptions: {
        external: (id: string) => id.startsWith('node:') || builtinModules.includes(id) || isOfHost(id),
      },
    },
  }),
);
