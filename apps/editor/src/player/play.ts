/**
 * Plays a scene on a page of its own: an exported page, or an embedded frame. The scene is in the element `farol-scene`
 * (base64 of a `.farol` file), or in the URL's hash (`#scene=…`).
 */
import { firstLanguage, setTexts, t } from '@farol/editing';
import {
  App,
  AssetLibrary,
  audioOutput,
  builtinComponents,
  ComponentRegistry,
  KeyController,
  MouseController,
  type Scene,
  TouchControls,
  watchPixelRatio,
} from '@farol/engine';
import { deserialize, FileError, type ForeignAddress, readSceneFile } from '@farol/engine/files';
import type { XRStage } from '@farol/engine/xr';
import { registerSceneAssets } from '@farol/scenes';
import { Box3, PerspectiveCamera, Vector3, type WebGLRenderer } from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { decodeLink } from '../files/share/linkText';
import { player } from '../language/es/player';
import { askForHosts, askForScripts } from './ask';
import { hasParticles } from './hasParticles';
import { needsParticles } from '../files/share/needsParticles';
import { hasScripts, isSandboxed, showSandboxed, tellReady } from './sandbox';
import { playWithParticles } from './withParticles';

const bytesOf = (base64: string): Uint8Array => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

/** Components of plugins, and of scripts that do not run, are kept as data, and do nothing. */
const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });

/** Runs the scripts of a scene; fulfilled when its components are instances of their classes. */
export type RunScripts = (scene: Scene, registry: ComponentRegistry) => Promise<void>;

/** A scene, and the function that runs its scripts; null when they do not run. */
interface Opened {
  readonly scene: Scene;
  readonly runScripts: RunScripts | null;
}

/** Placeholder for a scene that a sandboxed frame or another player shows. */
interface Elsewhere {
  readonly ready: Promise<void>;
}

/** @param runScripts - null in the player without scripts */
async function readScene(renderer: WebGLRenderer, runScripts: RunScripts | null): Promise<Opened | Elsewhere> {
  const element = document.getElementById('farol-scene');
  const assets = new AssetLibrary({ renderer });
  registerSceneAssets(assets);
  if (element) {
    const { text, fileOf } = await readSceneFile(bytesOf(element.textContent.trim()));
    // the author of an exported page has allowed its hosts, as its content policy says
    return { scene: await deserialize(text, { assets, registry, fileOf, mayFetch: () => true }), runScripts };
  }
  let hosts: readonly string[] = [];
  const mayFetch = async (addresses: readonly ForeignAddress[]): Promise<readonly string[]> => {
    hosts = await askForHosts(addresses);
    keepToHosts(hosts);
    return hosts;
  };
  assets.onChange((change) => change.error && say(change.error.message));
  const text = await decodeLink(location.hash);
  // scripts from a link are untrusted: they run in a sandboxed frame
  if (hasScripts(text) && (!runScripts || !isSandboxed())) {
    return { ready: showSandboxed() };
  }
  if (!hasParticles && needsParticles(text)) {
    return { ready: playWithParticles() };
  }
  const runs = hasScripts(text) && (await askForScripts());
  const scene = await deserialize(text, { assets, registry, mayFetch });
  // the page is restricted even when no question was asked, so that nothing is fetched later from other hosts
  keepToHosts(hosts);
  return { scene, runScripts: runs ? runScripts : null };
}

/** Shows a message over the scene, below earlier ones. */
export function say(text: string): void {
  let place = document.querySelector('[role=alert]');
  if (!place) {
    place = document.createElement('p');
    place.setAttribute('role', 'alert');
    document.body.prepend(place);
  }
  place.textContent = [place.textContent, text].filter(Boolean).join('\n');
}

/** Shows that sound is blocked until the user interacts with the page, as browsers require. */
function sayWhenMuted(): void {
  const line = document.createElement('p');
  line.setAttribute('role', 'status');
  const update = (): void => {
    line.textContent = audioOutput.isWaiting ? t('Click for sound') : '';
    line.hidden = !audioOutput.isWaiting;
  };
  audioOutput.onChange(update);
  update();
  document.body.append(line);
}

/** Adds buttons for headsets, if there is one. @param other - members of the stage that replace those of the app */
async function addXR(app: App, other: Partial<XRStage> = {}): Promise<void> {
  const { addXRButtons, stageOf } = await import('@farol/engine/xr');
  const place = document.createElement('div');
  place.className = 'xr';
  document.body.append(place);
  const labels = { 'immersive-vr': t('Enter VR'), 'immersive-ar': t('Enter AR') };
  await addXRButtons(
    place,
    labels,
    () => Object.assign(stageOf(app), other),
    ({ message }) => say(message),
  );
}

/** Adds an orbiting camera for the viewer, when the scene's camera cannot be moved by the user. */
function orbit(app: App): (width: number, height: number) => void {
  const camera = new PerspectiveCamera(50, 1, 0.05, 2000);
  const controls = new OrbitControls(camera, app.canvas);
  const { scene } = app;
  scene.three.updateMatrixWorld();
  const box = new Box3().setFromObject(scene.three);
  const middle = box.isEmpty() ? new Vector3() : box.getCenter(new Vector3());
  const active = scene.activeCamera?.three;
  if (active) {
    active.updateWorldMatrix(true, false);
    active.matrixWorld.decompose(camera.position, camera.quaternion, new Vector3());
    if (active instanceof PerspectiveCamera) camera.fov = active.fov;
    // the camera orbits the point straight ahead, at the distance of the scene's centre
    const ahead = new Vector3(0, 0, -1).applyQuaternion(camera.quaternion);
    const distance = Math.max(1, middle.clone().sub(camera.position).dot(ahead));
    controls.target.copy(camera.position).addScaledVector(ahead, distance);
  } else {
    const size = box.isEmpty() ? 4 : box.getSize(new Vector3()).length();
    camera.position.copy(middle).add(new Vector3(0.5, 0.4, 0.8).multiplyScalar(size));
    controls.target.copy(middle);
  }
  controls.enableDamping = true;
  const xr = { camera, advance: (seconds: number) => app.scene.update(seconds) };
  if ('xr' in navigator) void addXR(app, xr);
  let last = 0;
  const frame = (now: number): void => {
    requestAnimationFrame(frame);
    if (app.picture.inXR) return;
    const { scene } = app;
    scene.pointerCamera = camera;
    scene.update(last === 0 ? 0 : Math.min((now - last) / 1000, 0.1));
    last = now;
    controls.update();
    app.picture.render(scene, camera, scene.activeCamera);
  };
  requestAnimationFrame(frame);
  return (width, height) => {
    camera.aspect = width / height;
    camera.updateProjectionMatrix();
  };
}

/** Whether the user moves within the scene, rather than around it. */
export function isWalked(scene: Scene): boolean {
  if (!scene.activeCamera) return false;
  let found = scene.componentsOf('CharacterController').length > 0;
  scene.traverse((object) => {
    found ||= object.getComponent(KeyController) !== null || object.getComponent(MouseController) !== null;
  });
  return found;
}

/** Switches to the user's language. */
export function useLanguage(): void {
  if (firstLanguage(null, navigator.languages) !== 'es') return;
  setTexts(player, 'es');
  document.documentElement.lang = 'es';
}

/** Plays the app's scene over the whole page. @param walks - whether the user moves within it, rather than around it */
export function showScene(app: App, { name }: Scene, walks: boolean): void {
  sayWhenMuted();
  document.title = name;
  app.canvas.setAttribute('role', 'img');
  app.canvas.setAttribute('aria-label', name);
  let resized: (width: number, height: number) => void = () => {};
  if (walks) {
    app.start();
    if ('xr' in navigator) void addXR(app);
    new TouchControls(app.canvas, document.body, () => app.scene, t('Jump'));
  } else resized = orbit(app);
  const resize = (): void => {
    const { innerWidth: width, innerHeight: height } = window;
    app.resize(Math.max(1, width), Math.max(1, height), Math.min(devicePixelRatio, 2));
    resized(Math.max(1, width), Math.max(1, height));
  };
  addEventListener('resize', resize);
  watchPixelRatio(resize);
  resize();
}

/** Loads and plays the scene of the page. @param playerScripts - null in the player without scripts */
async function start(playerScripts: RunScripts | null): Promise<App | Elsewhere> {
  useLanguage();
  const app = new App({ parent: document.body, renderer: { antialias: true } });
  const opened = await readScene(app.webgl, playerScripts);
  if ('ready' in opened) {
    app.dispose();
    return opened;
  }
  const { scene, runScripts } = opened;
  const loggedErrors = new Set<string>();
  scene.onComponentError = (component, error) => {
    const owner = component.isAttached ? component.gameObject.name : '';
    const text = `${component.typeName} of ${owner}: ${error instanceof Error ? error.message : String(error)}`;
    if (!loggedErrors.has(text)) console.error(text, error);
    loggedErrors.add(text);
  };
  const scripted = scene.assets.fieldAssets('script').length > 0 && runScripts !== null;
  if (scripted) await runScripts(scene, registry);
  app.scene = scene;
  showScene(app, scene, scripted ? scene.activeCamera !== null : isWalked(scene));
  return app;
}

/**
 * Loads and plays the scene of the page, showing errors.
 * @param runScripts - null in the player without scripts
 * @returns fulfilled when the scene is loaded and completely drawn, see `App.ready`. The embedding page, if any, then
 *   receives the message `{ farol: 'ready' }`
 */
export function play(runScripts: RunScripts | null): Promise<void> {
  const started = start(runScripts);
  started.catch((error: unknown) => {
    const text = error instanceof FileError || error instanceof Error ? error.message : String(error);
    say(text);
    throw error;
  });
  const ready = started.then((shown) => shown.ready);
  // errors are shown by `start`, and reach those who await `ready`
  ready.then(tellReady, () => {});
  return ready;
}

/** Restricts the page, including workers, to fetching from its own and the given hosts; it can show no other page. */
function keepToHosts(hosts: readonly string[]): void {
  const policy = document.createElement('meta');
  policy.httpEquiv = 'Content-Security-Policy';
  const allowed = hosts.filter((host) => /^https?:\/\/[\w.:[\]-]+$/.test(host));
  policy.content = `connect-src 'self' data: blob: ${allowed.join(' ')}; frame-src 'none'`;
  document.head.append(policy);
  // WebRTC is removed, since no content policy covers its connections
  for (const name of ['RTCPeerConnection', 'webkitRTCPeerConnection']) Reflect.deleteProperty(globalThis, name);
}
