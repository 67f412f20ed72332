import { readFile } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { contentSecurityPolicy, policyElement } from '@farol/tools/contentSecurityPolicy';
import { sourceConditions } from '@farol/tools/sourceConditions';
import { build, type Plugin, type ViteDevServer } from 'vite';

const root = fileURLToPath(new URL('.', import.meta.url));

/** Stub of the decoders, so that pages without compressed models stay small. */
const noDecoder = `export class DRACOLoader {
  constructor() {
    throw new Error('it has compressed meshes or textures, which this page cannot read: export the scene as a web page.');
  }
}
export { DRACOLoader as KTX2Loader };`;

/** Replaces the decoders of Draco and KTX2 (2.7 MB) by stubs. */
function withoutDecoders(): Plugin {
  const id = '\0no-decoder';
  return {
    name: 'farol-no-decoders',
    enforce: 'pre',
    resolveId: (source) => (/\/(DRACO|KTX2)Loader\.js$/.test(source) ? id : null),
    load: (loaded) => (loaded === id ? noDecoder : null),
  };
}

/** Makes the player load Rapier from `farol-player-physics.js` (4.3 MB) instead of containing it. */
function withoutRapier(): Plugin {
  const own = fileURLToPath(new URL('src/player/loadRapier.ts', import.meta.url));
  return {
    name: 'farol-no-rapier',
    enforce: 'pre',
    // packages in `dist` import with an extension, sources without
    resolveId: (source, importer) => (importer && /\/loadRapier(\.js)?$/.test(source) ? own : null),
  };
}

/** Stub of the renderer's particles, so that pages without particles stay small. */
const noParticles = `export const ParticleEmitter = null, Particles = null, particlePresets = null;
throw new Error('The page has no particles: export the scene anew.');`;

/** Replaces the renderer's particles by stubs, and sets `hasParticles` to false. */
function withoutParticles(): Plugin {
  const code: Readonly<Record<string, string>> = {
    '\0no-particles': noParticles,
    '\0has-no-particles': 'export const hasParticles = false;',
  };
  return {
    name: 'farol-no-particles',
    enforce: 'pre',
    resolveId(source) {
      if (source === '@farol/renderer/particles') return '\0no-particles';
      return source.endsWith('/hasParticles') ? '\0has-no-particles' : null;
    },
    load: (loaded) => code[loaded] ?? null,
  };
}

interface PlayerParts {
  /** Whether the player can read compressed models. */
  readonly decoders?: boolean;
  /** Whether the player runs scripts, which may use all of three and of the engine, particles included. */
  readonly scripts?: boolean;
  readonly particles?: boolean;
}

/** Builds the player as one classic script with all dynamic imports inlined, which runs without a server. */
function buildPlayer(
  fromSource: boolean,
  { decoders = false, scripts = false, particles = scripts }: PlayerParts = {},
): Promise<string> {
  const plugins = [withoutRapier()];
  if (!decoders) plugins.push(withoutDecoders());
  if (!particles) plugins.push(withoutParticles());
  return buildScript(`src/player/${scripts ? 'mainWithScripts' : 'main'}.ts`, 'FarolPlayer', fromSource, plugins);
}

/** Builds one classic script. @param name - name of its global variable */
async function buildScript(entry: string, name: string, fromSource: boolean, plugins: Plugin[]): Promise<string> {
  const result = await build({
    root,
    configFile: false,
    publicDir: false,
    logLevel: 'warn',
    mode: 'production',
    plugins,
    define: { 'process.env.NODE_ENV': '"production"' },
    resolve: { dedupe: ['three'], ...(fromSource ? { conditions: sourceConditions } : {}) },
    build: {
      write: false,
      target: 'es2022',
      lib: { entry, formats: ['iife'], name },
      rolldownOptions: { output: { codeSplitting: false } },
    },
  });
  const outputs = (Array.isArray(result) ? result : [result]).flatMap((each) => ('output' in each ? each.output : []));
  const script = outputs.find((output) => output.type === 'chunk');
  if (!script) throw new Error('The build of the player has no script: see its entry in player.config.ts.');
  return script.code;
}

/**
 * The page for embedded frames.
 * @param runsScripts - builds the page for scenes with scripts from links, which is shown in a sandboxed frame
 */
async function playerPage(runsScripts: boolean): Promise<string> {
  const text = await readFile(new URL('player.html', import.meta.url), 'utf8');
  const script = runsScripts ? 'farol-player-scripts.js' : 'farol-player.js';
  return text
    .replace('<head>', `$&\n    ${policyElement(contentSecurityPolicy({ runsScripts }))}`)
    .replace('./farol-player.js', `./${script}`);
}

/** The page that follows an editor, see `src/player/live/main.ts`; only the development server has it. */
async function livePage(server: ViteDevServer): Promise<string> {
  const text = await readFile(new URL('player.html', import.meta.url), 'utf8');
  const page = text.replace(
    '<script src="./farol-player.js">',
    '<script type="module" src="/src/player/live/main.ts">',
  );
  return server.transformIndexHtml('/live.html', page);
}

/**
 * Serves and builds the player's files. `farol-player.js` is included in exported pages and run by embedded frames; it
 * has variants with decoders for compressed models, with particles, and with scripts. `farol-player-physics.js` is
 * loaded for scenes with physics, `farol-script-compiler.js` for scenes with scripts from links. `player.html` and
 * `player-scripts.html` are the pages of embedded frames.
 */
export function playerPlugin(): Plugin {
  const scripts = new Map<string, Promise<string>>();
  const filesOf = (command: 'serve' | 'build'): Readonly<Record<string, () => Promise<string>>> => {
    const fromSource = command === 'serve';
    return {
      'farol-player.js': () => buildPlayer(fromSource),
      'farol-player-decoders.js': () => buildPlayer(fromSource, { decoders: true }),
      'farol-player-particles.js': () => buildPlayer(fromSource, { particles: true }),
      'farol-player-particles-decoders.js': () => buildPlayer(fromSource, { particles: true, decoders: true }),
      'farol-player-scripts.js': () => buildPlayer(fromSource, { scripts: true }),
      'farol-player-scripts-decoders.js': () => buildPlayer(fromSource, { scripts: true, decoders: true }),
      'farol-script-compiler.js': () => buildScript('src/player/compiler.ts', 'FarolCompiler', fromSource, []),
      'farol-player-physics.js': () => buildScript('src/player/physics.ts', 'FarolPhysics', fromSource, []),
      'player.html': () => playerPage(false),
      'player-scripts.html': () => playerPage(true),
    };
  };
  const types: Readonly<Record<string, string>> = { js: 'text/javascript', html: 'text/html' };
  return {
    name: 'farol-player',
    configureServer(server) {
      const files = filesOf('serve');
      server.middlewares.use((request, response, next) => {
        const name = (request.url ?? '').split('?')[0].slice(1);
        if (name === 'live.html') {
          void livePage(server).then((page) => response.setHeader('Content-Type', 'text/html').end(page), next);
          return;
        }
        if (!Object.hasOwn(files, name)) return next();
        let content = scripts.get(name);
        if (!content) scripts.set(name, (content = files[name]()));
        content.then(
          (bytes) => {
            response.setHeader('Content-Type', types[name.slice(name.lastIndexOf('.') + 1)]);
            response.end(bytes);
          },
          (error: unknown) => next(error),
        );
      });
    },
    async generateBundle() {
      for (const [fileName, make] of Object.entries(filesOf('build'))) {
        this.emitFile({ type: 'asset', fileName, source: await make() });
      }
    },
  };
}
