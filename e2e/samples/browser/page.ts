import { App, createWebGLRenderer, noWebGL2, TouchControls, watchPixelRatio } from '@farol/engine';
import { collectFiles, type FileMap, makeKTX2Loader } from '@farol/engine/files';
import { playInXR, xrModes } from '@farol/engine/xr';
import { clearLearnt, learntChoices } from '@farol/renderer';
import { PerspectiveCamera } from 'three';

if (!document.createElement('canvas').getContext('webgl2')) document.body.textContent = noWebGL2;

const webgl = createWebGLRenderer({ antialias: true }); // throws with what to do, where there is no WebGL 2
const loader = await makeKTX2Loader(webgl);
loader.dispose();

const app = new App({ parent: document.body });
const touch = new TouchControls(app.canvas, document.body, () => app.scene, 'Jump');
touch.dispose();

const end = watchPixelRatio(() => app.webgl.setPixelRatio(devicePixelRatio));
end();

const drop = async (transfer: DataTransfer): Promise<FileMap> => {
  const files = await collectFiles(transfer); // folders with all that is in them
  return files;
};
if ((await drop(new DataTransfer())).size > 0) throw new Error('Nothing was dropped.');

const { picture, scene } = app;
const stage = { picture, scene, camera: new PerspectiveCamera(), advance: () => {}, pause: () => {}, resume: () => {} };
for (const mode of await xrModes()) {
  const button = document.createElement('button');
  button.addEventListener('click', () => void playInXR(stage, mode));
}

const learnt = await learntChoices();
if (learnt.length > 0) console.log(learnt[0]);
await clearLearnt(); // `technique: 'auto'` begins to learn anew
app.dispose();
