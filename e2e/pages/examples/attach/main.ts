/** Opens Farol's editor over a page that knows nothing of it (page.ts). */
import '../shared/example.css';
import { attachEditor } from '@farol/attach';
import { readCanvas } from '../shared/examplePage';
import { camera, drawFrame, renderer, scene } from './page';

const address = new URLSearchParams(location.search);
if (address.has('still')) drawFrame(1);
else renderer.setAnimationLoop((milliseconds) => drawFrame(milliseconds / 1000));

const open = () => attachEditor(scene, camera, renderer);
let editor = address.has('closed') ? null : open();

const button = document.createElement('button');
button.textContent = 'Editor';
button.addEventListener('click', () => {
  editor?.dispose();
  editor = editor ? null : open();
});
document.querySelector('nav')!.append(button);

/** Interface for the browser tests. */
const page = {
  ready: Promise.resolve(),
  scene,
  camera,
  webgl: renderer,
  drawFrame,
  get editor() {
    return editor;
  },
  get farol() {
    return editor!.farol!;
  },
  async draw(by: Parameters<NonNullable<typeof editor>['drawWith']>[0]) {
    await editor!.drawWith(by);
    drawFrame(1);
    return readCanvas(renderer);
  },
};
window.example = page;
