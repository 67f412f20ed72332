/** Position rebuilt from depth, beside position that is stored, and the way back of one pixel (thesis 2.2.3.1.2, 3.1.1). */
import { AmbientLight, DirectionalLight, Matrix4, Raycaster, Vector2, Vector4 } from 'three';
import { Figure } from './frame/Figure';
import { room } from './frame/room';
import { PositionView, type PositionShow } from './buffers/PositionView';

const figure = new Figure({ from: [3.6, 3.4, 7.2], at: [0, 1, 0], farol: { technique: 'forward-single-pass' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe('World positions as colours', 'Posiciones en el mundo, como colores');
const objects = room();
const sun = new DirectionalLight(0xffffff, 2);
sun.position.set(3, 6, 4);
scene.add(objects, sun, new AmbientLight(0xffffff, 0.6));
const view = new PositionView();
farol.effects = [view];

controls.choice<PositionShow>({
  name: 'show',
  label: '',
  value: 'rebuilt',
  options: [
    ['stored', say('stored XYZ', 'XYZ guardada')],
    ['rebuilt', say('rebuilt from depth', 'reconstruida')],
    ['error', say('error', 'error')],
  ],
  change: (value) => void (view.show = value),
});
controls.choice({
  name: 'bits',
  label: say('Depth', 'Profundidad'),
  value: '0',
  options: [
    ['0', '32 F'],
    ['24', '24 bit'],
    ['16', '16 bit'],
    ['10', '10 bit'],
  ],
  change: (value) => void (view.depthBits = Number(value)),
});
controls.check({
  name: 'half',
  label: say('store 16F', 'guardar en 16F'),
  value: false,
  change: (on) => void (view.halfFloats = on),
});
controls.range({
  name: 'gain',
  label: say('Error', 'Error'),
  value: 3,
  min: 0,
  max: 6,
  format: (power) => `× ${10 ** power}`,
  change: (power) => void (view.gain = 10 ** power),
});
controls.range({
  name: 'near',
  label: say('Near plane (m)', 'Plano cercano (m)'),
  value: 0.1,
  min: 0.01,
  max: 2,
  step: 0.01,
  change(value) {
    camera.near = value;
    camera.updateProjectionMatrix();
  },
});

/** Pixel (normalised device coordinates) whose position the text rebuilds step by step. */
const at = new Vector2(0.15, -0.1);
const steps = document.createElement('pre');
steps.tabIndex = 0;
steps.setAttribute('aria-label', say('The way back of one pixel', 'El camino inverso de un píxel'));
figure.strip.append(steps);
const numbers = (values: readonly number[]): string => values.map((value) => value.toFixed(4).padStart(9)).join(' ');

/** Writes the way from a pixel and its depth to the world, as the thesis describes it. */
function tellWay(): void {
  const ray = new Raycaster();
  ray.setFromCamera(at, camera);
  const [hit] = ray.intersectObject(objects, true);
  if (hit === undefined) {
    steps.textContent = say('No surface at this pixel.', 'No hay superficie en este píxel.');
    return;
  }
  const clip = new Vector4(hit.point.x, hit.point.y, hit.point.z, 1)
    .applyMatrix4(camera.matrixWorldInverse)
    .applyMatrix4(camera.projectionMatrix);
  const z = clip.z / clip.w;
  const back = new Matrix4().multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse).invert();
  const before = new Vector4(at.x, at.y, z, 1).applyMatrix4(back);
  const { x, y, z: oz, w } = before;
  steps.textContent = [
    `${say('depth', 'profundidad').padEnd(22)} ${((z + 1) / 2).toFixed(7)}`,
    `${say('x, y, 2·depth − 1, 1', 'x, y, 2·prof. − 1, 1').padEnd(22)}${numbers([at.x, at.y, z, 1])}`,
    `${'× VP⁻¹'.padEnd(22)}${numbers([x, y, oz, w])}`,
    `${say('÷ w: world (m)', '÷ w: mundo (m)').padEnd(22)}${numbers([x / w, y / w, oz / w])}`,
    `${say('where the ray hits', 'donde da el rayo').padEnd(22)}${numbers(hit.point.toArray())}`,
  ].join('\n');
}
webgl.domElement.addEventListener('pointermove', ({ offsetX, offsetY }) => {
  const { clientWidth, clientHeight } = webgl.domElement;
  at.set((2 * offsetX) / clientWidth - 1, 1 - (2 * offsetY) / clientHeight);
  tellWay();
});
figure.drawFrame = () => {
  farol.render(scene, camera);
  figure.label([{ text: '+', x: (at.x + 1) / 2, y: (1 - at.y) / 2 - 0.02 }]);
  tellWay();
};
figure.tell(
  'Point at a surface: the numbers below go the way back from the pixel. A colour is a position, two metres a cycle.',
  'Señale una superficie: los números recorren el camino inverso desde el píxel. Un color es una posición, dos metros por ciclo.',
);

export { camera, farol, figure, scene, webgl };
