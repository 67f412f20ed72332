import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { build, type Plugin } from 'vite';

const root = fileURLToPath(new URL('.', import.meta.url));

/** In the place of a decoder, so that pages without compressed models stay small. */
const noDecoder = `export class DRACOLoader {
  constructor() {
    throw new Error('it has compressed meshes or textures, which this page cannot read: export the scene as a web page.');
  }
}
export { DRACOLoader as KTX2Loader };`;

/** Leaves the decoders of Draco and KTX2 out: 2.7 MB. */
function withoutDecoders(): Plugin {
  const id = '\0no-decoder';
  return {
    name: 'farol-no-decoders',
    enforce: 'pre',
    resolveId: (source) => (/\/(DRACO|KTX2)Loader\.js$/.test(source) ? id : null),
    load: (loaded) => (loaded === id ? noDecoder : null),
  };
}

/** The player as one classic script, with everything that it would load late inside: it runs without a server. */
async function buildPlayer(fromSource: boolean, decoders: boolean): Promise<string> {
  const result = await build({
    root,
    configFile: false,
    publicDir: false,
    logLevel: 'warn',
    mode: 'production',
    plugins: decoders ? [] : [withoutDecoders()],
    define: { 'process.env.NODE_ENV': '"production"' },
    resolve: {
      dedupe: ['three'],
      ...(fromSource ? { conditions: ['development', 'module', 'browser'] } : {}),
    },
    build: {
      write: false,
      target: 'es2022',
      lib: { entry: 'src/player/main.ts', formats: ['iife'], name: 'FarolPlayer' },
      rolldownOptions: { output: { codeSplitting: false } },
    },
  });
  const outputs = (Array.isArray(result) ? result : [result]).flatMap((each) => ('output' in each ? each.output : []));
  const script = outputs.find((output) => output.type === 'chunk');
  if (!script) throw new Error('The player gave no script.');
  return script.code;
}

/**
 * Serves and builds `farol-player.js`, which exported pages hold and embedded frames run, `farol-player-decoders.js`, the
 * same with decoders of compressed models, and `player.html`, which embedded frames show.
 */
export function playerPlugin(): Plugin {
  const scripts = new Map<string, Promise<string>>();
  const files: Readonly<Record<string, (fromSource: boolean) => Promise<string>>> = {
    'farol-player.js': (fromSource) => buildPlayer(fromSource, false),
    'farol-player-decoders.js': (fromSource) => buildPlayer(fromSource, true),
    'player.html': () => readFile(new URL('player.html', import.meta.url), 'utf8'),
  };
  return {
    name: 'farol-player',
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const name = (request.url ?? '').split('?')[0].slice(1);
        if (!Object.hasOwn(files, name)) return next();
        let content = scripts.get(name);
        if (!content) scripts.set(name, (content = files[name](true)));
        content.then(
          (text) => {
            response.setHeader('Content-Type', name.endsWith('.js') ? 'text/javascript' : 'text/html');
            response.end(text);
          },
          (error: unknown) => next(error),
        );
      });
    },
    async generateBundle() {
      for (const fileName of Object.keys(files)) {
        this.emitFile({ type: 'asset', fileName, source: await files[fileName](false) });
      }
    },
  };
}
