/**
 * A technique of your own
 *
 * An array of passes made of the parts of `@farol/renderer/authoring`: the G-buffer, filled from near to far.
 *
 * @tags technique, authoring, deferred
 */
import { FarolRenderer } from '@farol/renderer';
import {
  ACESFilmicToneMapping,
  Color,
  HemisphereLight,
  Mesh,
  MeshBasicMaterial,
  MeshStandardMaterial,
  PerspectiveCamera,
  PlaneGeometry,
  PointLight,
  Scene,
  SphereGeometry,
  TorusGeometry,
  WebGLRenderer,
} from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import {
  DeferredOutputPass,
  fitsGBuffer,
  forwardTail,
  type Frame,
  GBufferTarget,
  gbufferTwin,
  LightVolumesPass,
  type Pass,
  type RenderItem,
  type Technique,
} from '@farol/renderer/authoring';

const canvas = document.querySelector('canvas')!;
const webgl = new WebGLRenderer({ canvas, antialias: true });
webgl.toneMapping = ACESFilmicToneMapping;
const farol = new FarolRenderer(webgl);

const scene = new Scene();
scene.background = new Color(0x05070b);
const camera = new PerspectiveCamera(42, 1, 0.1, 100);
camera.position.set(6, 4, 9);
const controls = new OrbitControls(camera, canvas);
controls.target.set(0, 1, 0);
controls.update();

/** Fills the G-buffer from near to far, whatever the materials: what is hidden is not shaded. */
class NearFirstPass implements Pass {
  readonly name = 'surfaces, near first';
  readonly reads = [] as const;
  readonly writes = ['gbuffer', 'scene-depth'] as const;
  private readonly target = new GBufferTarget();
  private readonly items: RenderItem[] = [];

  get bytes(): number {
    return this.target.bytes;
  }

  render(frame: Frame): void {
    const { items } = this;
    items.length = 0;
    for (const item of frame.queue.opaque) if (fitsGBuffer(item)) items.push(item);
    items.sort((a, b) => a.z - b.z);
    const gbuffer = this.target.begin(frame);
    for (const item of items) {
      frame.drawTwin(item, gbufferTwin);
      item.drawn = true; // else it is drawn forward too
    }
    frame.resources.put('gbuffer', gbuffer);
    frame.resources.put('scene-depth', gbuffer.depth);
  }

  dispose(): void {
    this.target.dispose();
  }
}
const nearFirst: Technique = {
  label: 'Deferred, near first',
  help: 'Deferred shading that draws near surfaces before far ones.',
  lightOrder: 'by-volume',
  needsFloatTargets: true,
  fills: 'every-pixel',
  passes: () => [new NearFirstPass(), new LightVolumesPass(), new DeferredOutputPass(), ...forwardTail('lightLoopAll')],
};
farol.technique = farol.addTechnique('near-first', nearFirst);

const floor = new Mesh(new PlaneGeometry(40, 40), new MeshStandardMaterial({ color: 0x7e8088, roughness: 0.85 }));
floor.rotation.x = -Math.PI / 2;
scene.add(floor, new HemisphereLight(0x90a8e0, 0x302820, 0.2));
const arch = new TorusGeometry(1.6, 0.16, 16, 64);
for (let i = 0; i < 14; i++) {
  const color = new Color().setHSL(0.55 + 0.02 * i, 0.5, 0.6);
  const mesh = new Mesh(arch, new MeshStandardMaterial({ color, roughness: 0.7 }));
  mesh.position.set(1.6 * Math.sin(0.45 * i), 0.9, 5 - 1.3 * i);
  mesh.rotation.y = 0.5 * Math.cos(0.45 * i);
  scene.add(mesh);
}
const bulb = new SphereGeometry(0.06, 16, 12);
const lights = Array.from({ length: 44 }, (_, i) => {
  const light = new PointLight(new Color().setHSL((0.02 * i + 0.9) % 1, 0.9, 0.6), 4, 3.6);
  light.add(new Mesh(bulb, new MeshBasicMaterial({ color: light.color })));
  scene.add(light);
  return light;
});

function resize(): void {
  camera.aspect = innerWidth / innerHeight;
  camera.updateProjectionMatrix();
  farol.setPixelRatio(Math.min(devicePixelRatio, 2));
  farol.setSize(innerWidth, innerHeight);
}
addEventListener('resize', resize);
resize();

webgl.setAnimationLoop((milliseconds) => {
  const seconds = milliseconds / 1000;
  for (const [i, light] of lights.entries()) {
    const along = (i + 0.8 * seconds) % lights.length;
    const turn = 1.3 * i + 0.8 * seconds;
    const z = 6 - 0.42 * along;
    light.position.set(1.6 * Math.sin(0.45 * ((5 - z) / 1.3)) + 1.1 * Math.cos(turn), 1.1 + 0.9 * Math.sin(turn), z);
  }
  farol.render(scene, camera);
});

export { camera, farol, scene, webgl };
