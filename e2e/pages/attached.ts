import { attachEditor } from '@farol/attach';
import { FarolRenderer } from '@farol/renderer';
import * as THREE from 'three';
import { EffectComposer } from 'three/addons/postprocessing/EffectComposer.js';
import { OutputPass } from 'three/addons/postprocessing/OutputPass.js';
import { RenderPass } from 'three/addons/postprocessing/RenderPass.js';

/** A page with a scene of a cube, to attach editors to; nothing moves, and each frame is asked for. */
export interface AttachedPage {
  three: typeof THREE;
  webgl: THREE.WebGLRenderer;
  scene: THREE.Scene;
  camera: THREE.PerspectiveCamera;
  farol: FarolRenderer;
  attachEditor: typeof attachEditor;
  /** Draws by stock three, by the page's own Farol, or through three's EffectComposer. */
  draw(by: 'three' | 'farol' | 'composer'): void;
  /** The canvas as the screen will show it, once all that follows a frame is done: RGBA bytes, bottom row first. */
  pixels(by: 'three' | 'farol' | 'composer'): Promise<number[]>;
}

declare global {
  interface Window {
    attachedPage: AttachedPage;
  }
}

const webgl = new THREE.WebGLRenderer({ antialias: false });
webgl.setSize(200, 120);
document.body.append(webgl.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0x203040);
const cube = new THREE.Mesh(new THREE.BoxGeometry(), new THREE.MeshStandardMaterial({ color: 0xcc8844 }));
cube.name = 'cube';
const light = new THREE.PointLight(0xffffff, 20);
light.name = 'lamp';
light.position.set(2, 2, 2);
scene.add(cube, light);
const camera = new THREE.PerspectiveCamera(50, 200 / 120, 0.1, 20);
camera.position.set(1, 1, 3);
camera.lookAt(0, 0, 0);
const farol = new FarolRenderer(webgl, { technique: 'deferred' });
const composer = new EffectComposer(webgl);
composer.addPass(new RenderPass(scene, camera));
composer.addPass(new OutputPass());

const draw: AttachedPage['draw'] = (by) => {
  if (by === 'three') webgl.render(scene, camera);
  else if (by === 'farol') farol.render(scene, camera);
  else composer.render(0);
};

window.attachedPage = {
  ...{ three: THREE, webgl, scene, camera, farol, attachEditor, draw },
  async pixels(by) {
    draw(by);
    await Promise.resolve(); // the overlay is drawn after the page's code, in this same turn
    const gl = webgl.getContext();
    const data = new Uint8Array(200 * 120 * 4);
    gl.readPixels(0, 0, 200, 120, gl.RGBA, gl.UNSIGNED_BYTE, data);
    return Array.from(data);
  },
};
