import { t } from '@farol/editing';
import type { Scene, ScriptAsset } from '@farol/engine';
import { foreignAddresses, readGltfJson, writeContainer } from '@farol/engine/files';
import { needsParticles } from './needsParticles';
import { compileScript, ScriptError } from '@farol/engine/scripts';
import { sharedContent, type ShareOptions } from './sharedContent';

function base64Of(bytes: Uint8Array): string {
  let letters = '';
  for (let i = 0; i < bytes.length; i += 0x8000) letters += String.fromCharCode(...bytes.subarray(i, i + 0x8000));
  return btoa(letters);
}

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;').replaceAll('"', '&quot;');

/** Whether a model among the assets needs a decoder. */
async function needsDecoders(files: Iterable<Blob>, scene: Scene): Promise<boolean> {
  const models = new Set(scene.assets.files.filter(({ type }) => type === 'model').map(({ blob }) => blob));
  for (const blob of files) {
    if (!models.has(blob)) continue;
    const { extensionsUsed = [] } = readGltfJson(await blob.arrayBuffer());
    if (extensionsUsed.some((name) => /draco|basisu/.test(name))) return true;
  }
  return false;
}

/** A file of the editor's site. @throws Error when it is missing */
async function fileBeside(name: string): Promise<Response> {
  const address = new URL(name, document.baseURI);
  const response = await fetch(address);
  if (!response.ok)
    throw new Error(`The player could not be read: ${address.href} answered ${response.status}. Reload the page.`);
  return response;
}

/** The player's script as text. @throws Error when it is missing */
async function playerScript(decoders: boolean, scripts: boolean, particles: boolean): Promise<string> {
  const parts = `${scripts ? '-scripts' : particles ? '-particles' : ''}${decoders ? '-decoders' : ''}`;
  return (await fileBeside(`farol-player${parts}.js`)).text();
}

/** Matches component names that show that a scene uses physics. */
const physicsNames = /\b(RigidBody|Collider|CharacterController|Joint)\b/;

/**
 * Element with the physics engine, compressed from 4.3 to 2.2 MB; '' for a scene without physics. @throws Error when
 * the file is missing
 */
async function physicsOf(file: object): Promise<string> {
  if (!physicsNames.test(JSON.stringify(file))) return '';
  const { body } = await fileBeside('farol-player-physics.js');
  const packed = await new Response(body!.pipeThrough(new CompressionStream('gzip'))).arrayBuffer();
  return `\n<script type="application/octet-stream" id="farol-physics">${base64Of(new Uint8Array(packed))}</script>`;
}

/** Compiled scripts of a scene. @throws ScriptError naming the first one that does not compile */
async function compiledScripts(scene: Scene): Promise<string[]> {
  const scripts = scene.assets.fieldAssets('script') as ScriptAsset[];
  if (scripts.length === 0) return [];
  const results = await Promise.all(scripts.map(({ name, source }) => compileScript(name, source)));
  return results.map((result) => {
    if (result instanceof ScriptError) throw result;
    return result.code;
  });
}

/** A random, unguessable string. */
const makeNonce = (): string => base64Of(crypto.getRandomValues(new Uint8Array(18)));

/**
 * Content security policy of the page: it may run its own script, decode models, and fetch from hosts that the scene
 * uses.
 * @see Content Security Policy Level 3
 */
function policyOf(hosts: Iterable<string>, nonce: string): string {
  const named = [...hosts].filter((host) => /^https?:\/\/[\w.:[\]-]+$/.test(host));
  return [
    "default-src 'none'",
    `script-src 'nonce-${nonce}' 'wasm-unsafe-eval'`,
    'worker-src blob:',
    `style-src 'nonce-${nonce}'`,
    'img-src data: blob:',
    ['connect-src data: blob:', ...named].join(' '),
    "base-uri 'none'",
    "form-action 'none'",
  ].join('; ');
}

/**
 * A self-contained web page that shows the scene: player, scene, compiled scripts and assets in one file, which also
 * works from disk.
 * @throws Error when the player cannot be read; ScriptError for a script that does not compile
 */
export async function exportHtml(scene: Scene, options: ShareOptions = {}): Promise<Blob> {
  const content = sharedContent(scene, options);
  const scripts = options.withScripts === false ? [] : await compiledScripts(scene);
  const hasParticles = needsParticles(JSON.stringify(content.file));
  const [script, bytes, physics] = await Promise.all([
    needsDecoders(content.files.values(), scene).then((decoders) =>
      playerScript(decoders, scripts.length > 0, hasParticles),
    ),
    writeContainer(content),
    physicsOf(content.file),
  ]);
  const nonce = makeNonce();
  const hosts = new Set(foreignAddresses(content.file).map(({ origin }) => origin));
  const page = `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="${policyOf(hosts, nonce)}">
<link rel="icon" href="data:,">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${escaped(scene.name)}</title>
<style nonce="${nonce}">html,body{height:100%;margin:0;overflow:hidden;background:#000}p{margin:1em;color:#eee;font:16px sans-serif;white-space:pre-line}</style>
</head>
<body>
<noscript><p>${escaped(t('This page shows a scene with JavaScript and WebGL 2: switch JavaScript on, or, where it is in a frame that allows no scripts, open it by itself.'))}</p></noscript>
<script type="application/octet-stream" id="farol-scene">${base64Of(bytes)}</script>${physics}
${[...scripts, script].map((code) => scriptElement(nonce, code)).join('\n')}
</body>
</html>
`;
  return new Blob([page], { type: 'text/html' });
}

/**
 * An inline script element. Sequences in the code that would end it, or hide its end, are escaped.
 * @see HTML, "Restrictions for contents of script elements"
 */
export const scriptElement = (nonce: string, code: string): string =>
  `<script nonce="${nonce}">${code.replaceAll(/<(?=\/script|!--)/gi, '\\x3C')}</script>`;
