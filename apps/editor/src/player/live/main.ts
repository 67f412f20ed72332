/** Page that shows an editor's scene on another device, with each edit: the player, connected to the dev server. */
import { t } from '@farol/editing';
import { App, AssetLibrary, builtinComponents, ComponentRegistry, type Scene } from '@farol/engine';
import { deserialize } from '@farol/engine/files';
import { compileScript, runInPage, SceneScripts } from '@farol/engine/scripts';
import { registerSceneAssets } from '@farol/scenes';
import { changeParts, type PartKey } from '../../files/autosave/parts';
import {
  changesBetween,
  fileOfParts,
  type LiveAsset,
  liveAsset,
  type LiveMessage,
  liveSocket,
  partsBelow,
  type RelayMessage,
  SCRIPTS,
} from '../../files/live/liveParts';
import { isWalked, say, showScene, useLanguage } from '../play';
import { applyParts } from './applyParts';

/** Delays before a lost connection is tried again (ms); the last one repeats. */
const RETRIES = [500, 1000, 2000, 5000];

/** Id of the shared session. */
const id = new URLSearchParams(location.search).get('look') ?? '';

useLanguage();
const app = new App({ parent: document.body, renderer: { antialias: true } });
const line = document.createElement('p');
line.setAttribute('role', 'status');
document.body.append(line);

/** JSON of the parts of the displayed scene. */
let shown: ReadonlyMap<PartKey, string> = new Map();
/** JSON of the scene's parts as last received; null until all parts have arrived. */
let told: Map<PartKey, string> | null = null;
/** JSON of the scene's parts while the whole scene is being received; null otherwise. */
let coming: Map<PartKey, string> | null = null;
let registry = new ComponentRegistry();
let scripts: SceneScripts | null = null;
let isShown = false;
let walks = false;
let isBusy = false;
/** Whether the scene is to restart, since the editor began to play. */
let restarts = false;

const blobs = new Map<string, Promise<Blob>>();

/** Fetches an asset's bytes, once. */
function fileOf(hash: string): Promise<Blob> {
  const fetched =
    blobs.get(hash) ??
    fetch(liveAsset(id, hash)).then((answer) => {
      if (!answer.ok)
        throw new Error(`An asset could not be fetched: the server answered ${answer.status}. Reload the page.`);
      return answer.blob();
    });
  blobs.set(hash, fetched);
  fetched.catch(() => blobs.delete(hash));
  return fetched;
}

/** Creates the scene from all its parts. */
async function makeScene(parts: ReadonlyMap<PartKey, string>): Promise<Scene> {
  const files = new Map<string, Blob>();
  for (const asset of partsBelow(parts, 'a/').values()) {
    const { file, hash } = asset as LiveAsset;
    if (file !== undefined && hash !== undefined) files.set(file, await fileOf(hash));
  }
  const assets = new AssetLibrary({ renderer: app.webgl });
  registerSceneAssets(assets);
  scripts?.dispose();
  scripts = null;
  registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const scene = await deserialize(fileOfParts(parts), {
    assets,
    registry,
    fileOf: (path) => files.get(path) ?? null,
    // the editor has already asked its user whether the scene may fetch from other hosts
    mayFetch: () => true,
  });
  scene.onComponentError = (component, error) => console.warn(component.typeName, error);
  if (parts.get(SCRIPTS) === 'true' && assets.fieldAssets('script').length > 0) {
    const { scriptModules } = await import('../../model/scriptModules');
    scripts = new SceneScripts(scene, registry, { modules: scriptModules, compile: compileScript, run: runInPage });
    await scripts.settled();
  }
  return scene;
}

/** Displays a scene in place of the previous one. */
function show(scene: Scene): void {
  const before = app.scene;
  const walked = isWalked(scene) || (scripts !== null && scene.activeCamera !== null);
  // a change between walking and orbiting needs a reload of the page
  if (isShown && walked !== walks) return location.reload();
  app.scene = scene;
  if (!isShown) showScene(app, scene, walked);
  walks = walked;
  isShown = true;
  document.title = scene.name;
  app.canvas.setAttribute('aria-label', scene.name);
  const { assets } = before;
  before.dispose();
  assets.dispose();
}

/** Updates the displayed scene to the received parts, one update after another. */
async function follow(): Promise<void> {
  if (isBusy) return;
  isBusy = true;
  try {
    for (
      let target = told;
      target;
      target = told && (restarts || changesBetween(shown, told).length > 0) ? told : null
    ) {
      const next = new Map(target);
      const changes = changesBetween(shown, next);
      const isApplied =
        isShown && !restarts && (await applyParts(app.scene, next, changes, registry, fileOf).catch(() => false));
      restarts = false;
      if (!isApplied) show(await makeScene(next));
      shown = next;
    }
  } catch (error) {
    say(error instanceof Error ? error.message : String(error));
  } finally {
    isBusy = false;
  }
}

function receive(message: LiveMessage | RelayMessage): void {
  if (message.kind === 'away') line.textContent = t('The editor is not connected; edits follow once it is.');
  else if (message.kind === 'play') restarts = isShown;
  else if (message.kind === 'whole') coming = new Map();
  else if (message.kind === 'parts') {
    const parts = coming ?? told;
    if (parts) changeParts(parts, message.parts);
  } else if (message.kind === 'end' && coming) {
    told = coming;
    coming = null;
    line.textContent = '';
  }
  line.hidden = line.textContent === '';
  if (told && !coming) void follow();
}

let socket: WebSocket | null = null;
let failures = 0;

function connect(): void {
  socket = liveSocket(`look=${id}`);
  socket.addEventListener('open', () => (failures = 0));
  socket.addEventListener('message', ({ data }) => receive(JSON.parse(String(data)) as LiveMessage | RelayMessage));
  socket.addEventListener('close', () => {
    coming = null;
    line.textContent = t('The connection was lost; trying again…');
    line.hidden = false;
    setTimeout(connect, RETRIES[Math.min(failures++, RETRIES.length - 1)]);
  });
}

// a suspended page may have missed edits, and its socket may be dead: the whole scene is requested again
document.addEventListener('visibilitychange', () => {
  if (!document.hidden && socket?.readyState === WebSocket.OPEN) socket.send('{"kind":"again"}');
});
/** Shows that the page waits for the editor, and connects. */
function start(): void {
  line.textContent = t('Waiting for the editor…');
  connect();
}

start();
