/** The thesis's scenes: grids of N × M planes or meshes and lights, temple, atrium, dragons, NiceScene (3.2.7, 3.2.8, 3.3, 4.1). */
import type { TechniqueName, View } from '@farol/renderer';
import type { Scene } from '@farol/engine';
import { scenes, type SceneParameters } from '@farol/scenes';
import { Figure } from './frame/Figure';
import { lookAsScene } from './frame/showScene';

type Name = 'benchmarkLights' | 'benchmarkLightsObjects' | 'temple' | 'sponza' | 'dragons' | 'niceScene';

const figure = new Figure({ from: [0, 22, 25], at: [0, 0, 1.5], pixelRatio: 1 });
const { farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
const grid = { n: 4, nRows: 6, m: 9, mRows: 6 };
/** Lights of the scenes that are no grids. */
let lights = 50;
let name: Name = 'benchmarkLights';
let shown: Scene | null = null;
let making = 0;
/** Scene that the camera was put in place for. */
let looked: Name | null = null;
let time = 0;

const parametersOf = (): SceneParameters =>
  name === 'benchmarkLights' || name === 'benchmarkLightsObjects'
    ? grid
    : name === 'sponza'
      ? { lights, textureSize: '128' }
      : { lights };

/** Makes the scene that is asked for; one that was asked for later takes its place. */
async function make(): Promise<void> {
  const one = ++making;
  const made = await scenes[name].build(parametersOf());
  if (one !== making) return made.dispose();
  shown?.dispose();
  shown = made;
  made.update(0);
  const distance = name === 'sponza' ? 12 : name.startsWith('bench') ? 30 : 9;
  if (looked !== name) lookAsScene(figure, made, distance);
  looked = name;
  figure.redraw();
}
let made: Promise<void> = Promise.resolve();
const remake = (): void => void (made = make());

figure.describe('The scene that is chosen', 'La escena elegida');
figure.drawFrame = () => {
  if (shown === null) return;
  farol.render(shown.three, camera);
  const { drawCalls, lights: found, technique, triangles } = farol.info;
  figure.tell(
    `${found.total} lights, ${triangles.toLocaleString('en')} triangles in ${drawCalls} draws by “${technique}”.`,
    `${found.total} luces, ${triangles.toLocaleString('es')} triángulos en ${drawCalls} dibujos con «${technique}».`,
  );
};
controls.choice<Name>({
  name: 'scene',
  label: '',
  value: 'benchmarkLights',
  options: [
    ['benchmarkLights', say('Planes', 'Planos')],
    ['benchmarkLightsObjects', say('Meshes', 'Mallas')],
    ['temple', say('Temple', 'Templo')],
    ['sponza', 'Sponza'],
    ['dragons', say('Dragons', 'Dragones')],
    ['niceScene', 'NiceScene'],
  ],
  change(value) {
    name = value;
    const isGrid = value.startsWith('bench');
    for (const key of ['n', 'nRows', 'm', 'mRows', 'lights']) controls.hide(key, isGrid === (key === 'lights'));
    remake();
  },
});
const size = (key: keyof typeof grid, label: string): void => {
  controls.range({
    name: key,
    label,
    value: grid[key],
    min: 1,
    max: 15,
    change(value) {
      if (grid[key] === value) return;
      grid[key] = value;
      remake();
    },
  });
};
size('n', say('Objects N', 'Objetos N'));
size('nRows', '× M');
size('m', say('Lights N', 'Luces N'));
size('mRows', '× M');
controls.range({
  name: 'lights',
  label: say('Lights', 'Luces'),
  value: 50,
  min: 1,
  max: 300,
  change(value) {
    if (lights === value) return;
    lights = value;
    remake();
  },
});
controls.choice<TechniqueName>({
  name: 'technique',
  label: say('Technique', 'Técnica'),
  value: 'deferred',
  options: [
    ['auto', 'Auto'],
    ['deferred', 'Deferred'],
    ['forward', 'Forward'],
  ],
  change: (value) => void (farol.technique = value),
});
controls.choice<View>({
  name: 'view',
  label: say('View', 'Vista'),
  value: 'final',
  options: [
    ['final', say('picture', 'imagen')],
    ['grid', 'G-Buffer'],
    ['light-count', say('lights', 'luces')],
  ],
  change: (value) => void (farol.view = value),
});
figure.animate((seconds) => {
  shown?.update(Math.max(0, seconds - time));
  time = seconds;
});

/** Fulfilled when the scene asked for last is shown. */
export const prepare = (): Promise<void> => made;
export { camera, farol, figure, webgl };
