/** Multipass lighting, pass by pass: each light is a draw more of what it reaches, added to the picture (thesis 2.2.1.3, 2.2.2). */
import { AmbientLight } from 'three';
import { Figure } from './frame/Figure';
import { lamps, room } from './frame/room';

/** Point lights of the figure. */
const LIGHTS = 8;

const figure = new Figure({ from: [3.6, 3.4, 7.2], at: [0, 1, 0], farol: { technique: 'forward' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'On the left one pass alone, on the right the sum of all passes so far',
  'A la izquierda una sola pasada, a la derecha la suma de las pasadas hasta ahora',
);
const ambient = new AmbientLight(0x8090b0, 0.5);
const { group, lights, move } = lamps(LIGHTS, 5, 9);
scene.add(room(), group, ambient);

/** Passes that are in the sum: ambient light, then so many lights. */
let passes = 3;

/** Leaves ambient light and the lights of these places on. */
function light(hasAmbient: boolean, isOn: (i: number) => boolean): void {
  ambient.intensity = hasAmbient ? 0.5 : 0;
  // intensity, not visibility: a lamp that is out keeps its bulb
  lights.forEach((one, i) => (one.intensity = isOn(i) ? 9 : 0));
}
/** One pass alone: 0 is ambient light. */
function drawPass(pass: number): void {
  light(pass === 0, (i) => i === pass - 1);
  farol.render(scene, camera);
}
function drawSum(count: number): void {
  light(true, (i) => i < count - 1);
  farol.render(scene, camera);
}
figure.drawFrame = () => {
  const name = passes === 1 ? say('ambient light', 'luz ambiente') : `${say('light', 'luz')} ${passes - 1}`;
  figure.panels([
    { text: `${say('Pass', 'Pasada')} ${passes}: ${name}`, draw: () => drawPass(passes - 1) },
    { text: `${say('Sum of', 'Suma de')} ${passes}`, draw: () => drawSum(passes) },
  ]);
  const draws = farol.info.passes.find(({ name: one }) => one === 'multipass lights')?.drawCalls ?? 0;
  figure.tell(
    `${draws} draws of 7 objects in this frame: each once with ambient light, then once more for every light that reaches it. Blending adds; depth is tested for equality.`,
    `${draws} dibujos de 7 objetos en este fotograma: cada uno una vez con la luz ambiente y otra por cada luz que lo alcanza. El blending suma; la profundidad se compara por igualdad.`,
  );
};
const set = controls.range({
  name: 'passes',
  label: say('Passes', 'Pasadas'),
  value: 3,
  min: 1,
  max: LIGHTS + 1,
  change: (value) => void (passes = value),
});
controls.button('next', say('Next pass', 'Pasada siguiente'), () => set(passes > LIGHTS ? 1 : passes + 1));
figure.lampSliders(
  { label: say('Range of the lights (m)', 'Alcance de las luces (m)'), value: 5, min: 1, max: 9, step: 0.5 },
  lights,
  move,
);

export { camera, drawPass, drawSum, farol, figure, LIGHTS, scene, webgl };
