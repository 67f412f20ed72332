/**
 * The viewer's page. It exposes `window.viewer`, an object of class Viewer, for tests and benchmarks:
 *
 * - `ready`: promise, fulfilled when the first scene is loaded and drawn
 * - `renderAt(seconds)`: draws exactly one frame, of the scene at that time
 * - `readPixels()`, `readStockPixels()`: the picture by Farol, and by three's own renderer, as
 *   `{ width, height, data: Float32Array }` of linear RGBA, bottom row first
 * - `setTechnique(name)`, `setView(name)`, `loadScene(name, parameters)`
 * - `farol`, `three` (the WebGLRenderer), `scene`, `camera`, `engineScene`
 *
 * Its address parameters are listed by the help panel (`?` on the page) and in state/ViewerState.ts.
 */
import { isTyping, type Language, latinKey, showPageLanguage, startPageLanguage, t } from '@farol/editing';
import './style.css';
import { acceptDrops } from './acceptDrops';
import { StoppedFlight } from './input/StoppedFlight';
import { TouchOrbit } from './input/TouchOrbit';
import { known } from './state/known';
import { HelpPanel } from './ui/HelpPanel';
import { Messages } from './ui/Messages';
import { ViewerMenu } from './ui/ViewerMenu';
import { Viewer } from './Viewer';
import { watchContext } from './watchContext';

declare global {
  interface Window {
    viewer: Viewer;
  }
}

/** Adds the buttons for headset sessions, if a headset is present. */
async function addXR({ app, messages }: Viewer): Promise<void> {
  const { addXRButtons, stageOf } = await import('@farol/engine/xr');
  const labels = { 'immersive-vr': t('Enter VR'), 'immersive-ar': t('Enter AR') };
  await addXRButtons(
    parent,
    labels,
    () => stageOf(app),
    ({ message }) => messages.show('xr', message),
  );
}

const spanish = async () => (await import('./language/es')).es;
const parent = document.getElementById('app')!;

/** @throws Error when the browser has no WebGL 2 */
function start(): void {
  const viewer = new Viewer(parent, location.search);
  window.viewer = viewer;
  const speak = async (language: Language): Promise<void> => {
    try {
      if (!(await showPageLanguage(language, spanish))) return;
    } catch {
      viewer.messages.show('language', t('The texts of this language could not be loaded: reload the page.'));
    }
    document.title = t('Farol viewer');
    menu.remove();
    help.remove();
    menu = new ViewerMenu(viewer, speak);
    help = new HelpPanel(parent, known);
  };
  let menu = new ViewerMenu(viewer, speak);
  let lacked = '';
  viewer.app.onFrame(() => {
    if (viewer.app.running) menu.statistics.frameDrawn(viewer.farol.info, performance.now());
    else menu.statistics.show(viewer.farol.info, null);
    const lacking = viewer.farol.info.view?.problem ?? '';
    if (lacking === lacked) return;
    lacked = lacking;
    viewer.messages.show('view', t(lacking));
  });
  let help = new HelpPanel(parent, known);
  new StoppedFlight(viewer);
  new TouchOrbit(viewer);
  acceptDrops(viewer);
  if ('xr' in navigator) void addXR(viewer);
  watchContext(viewer);
  addEventListener('keydown', (event) => {
    if (isTyping(event) || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === '?') help.toggle();
    else if (latinKey(event) === 'h') viewer.setGui(!viewer.state.gui);
    else if (event.key === ' ') viewer.toggleTime();
    else return;
    event.preventDefault();
  });
}

async function open(): Promise<void> {
  await startPageLanguage(spanish);
  document.title = t('Farol viewer');
  try {
    start();
  } catch (error) {
    const reason = error instanceof Error ? error.message : String(error);
    new Messages(parent).show('start', t('Farol cannot start: {reason}', { reason }));
    throw error;
  }
}

void open();
