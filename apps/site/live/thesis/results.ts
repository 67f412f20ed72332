/** The tables of chapter 4, filled by the reader's machine beside the thesis's own figures (thesis 4.2.2). */
import type { Scene } from '@farol/engine';
import type { TechniqueName } from '@farol/renderer';
import { type SceneParameters, scenes } from '@farol/scenes';
import { Figure } from './frame/Figure';
import { lookAsScene } from './frame/showScene';
import { measure } from './results/measure';
import { type ThesisRow, type ThesisTable, thesisTables } from './results/thesisTables';

const figure = new Figure({ from: [0, 22, 25], at: [0, 0, 1.5], pixelRatio: 1 });
const { farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe('The scene that is measured', 'La escena que se mide');

const sceneNames = { planes: 'benchmarkLights', sponza: 'sponza', temple: 'temple' } as const;
const columns = ['forward', 'deferred', 'clustered-deferred'] as const satisfies readonly TechniqueName[];
let table: ThesisTable = 'planes';
let shown: Scene | null = null;
/** Grows when a measurement is to end. */
let run = 0;

const element = document.createElement('table');
figure.strip.append(element);
let rows: HTMLTableRowElement[] = [];

figure.drawFrame = () => {
  if (shown !== null) farol.render(shown.three, camera);
};

/** Makes the scene of a row and looks at it as the scene's own camera does. */
async function show({ n, m }: ThesisRow): Promise<Scene> {
  const parameters: SceneParameters =
    n === undefined ? (table === 'sponza' ? { lights: m, textureSize: '128' } : { lights: m }) : { n, m };
  const made = await scenes[sceneNames[table]].build(parameters);
  shown?.dispose();
  shown = made;
  made.update(0);
  lookAsScene(figure, made, table === 'planes' ? 30 : 12);
  return made;
}
async function measureRow(at: number, mine = ++run): Promise<void> {
  const row = thesisTables[table][at];
  const { three } = await show(row);
  for (const [i, technique] of columns.entries()) {
    if (mine !== run) return;
    const cell = rows[at].cells[4 + i];
    cell.textContent = '…';
    farol.technique = technique;
    const { ms, by } = await measure(farol, three, camera, () => mine === run);
    if (mine !== run) cell.textContent = '';
    else cell.textContent = `${ms.toFixed(2)} ms · ${Math.round(1000 / ms)}`;
    cell.title =
      by === 'gpu' ? say('GPU timer', 'temporizador de la GPU') : say('clock of the page', 'reloj de la página');
    figure.tell(
      `${webgl.domElement.width} × ${webgl.domElement.height} pixels; ${by === 'gpu' ? 'times of the GPU alone' : 'this browser has no GPU timer: time from a draw to a pixel read back'}.`,
      `${webgl.domElement.width} × ${webgl.domElement.height} píxeles; ${by === 'gpu' ? 'tiempos sólo de la GPU' : 'este navegador no tiene temporizador de GPU: tiempo desde el dibujo hasta leer un píxel'}.`,
    );
  }
}
async function measureAll(): Promise<void> {
  const mine = ++run;
  for (let i = 0; i < rows.length && mine === run; i++) await measureRow(i, mine);
}
function makeTable(): void {
  run++;
  const head = [
    ...(table === 'planes' ? ['N', 'M'] : ['', say('Lights', 'Luces')]),
    say('Forward, 2015', 'Forward, 2015'),
    say('Deferred, 2015', 'Deferred, 2015'),
    say('Forward, here', 'Forward, aquí'),
    say('Deferred, here', 'Deferred, aquí'),
    say('Clustered, here', 'Clustered, aquí'),
    '',
  ];
  element.innerHTML = `<thead><tr>${head.map((text) => `<th>${text}</th>`).join('')}</tr></thead><tbody></tbody>`;
  rows = thesisTables[table].map(({ n, m, forward, deferred }, i) => {
    const row = element.tBodies[0].insertRow();
    for (const text of [n ?? '', m, forward ?? '–', deferred ?? '–', '', '', ''])
      row.insertCell().textContent = String(text);
    const button = document.createElement('button');
    button.type = 'button';
    button.textContent = say('Measure', 'Medir');
    button.addEventListener('click', () => void measureRow(i));
    row.insertCell().append(button);
    return row;
  });
}
let shownFirst: Promise<unknown> = Promise.resolve();

controls.choice<ThesisTable>({
  name: 'table',
  label: '',
  value: 'planes',
  options: [
    ['planes', say('N × N planes, M × M lights', 'N × N planos, M × M luces')],
    ['sponza', say('Sponza, N lights', 'Sponza, N luces')],
    ['temple', say('Temple, N lights', 'Temple, N luces')],
  ],
  change(value) {
    table = value;
    makeTable();
    shownFirst = show(thesisTables[value][0]).then(figure.redraw);
  },
});
controls.button('all', say('Measure all', 'Medir todo'), () => void measureAll());
controls.button('stop', say('Stop', 'Parar'), () => void run++);
figure.tell(
  'Frames a second of 2015, beside milliseconds and frames a second of this machine. Nothing is measured until you ask.',
  'Fotogramas por segundo de 2015 junto a milisegundos y fotogramas por segundo de esta máquina. No se mide nada hasta que lo pida.',
);

/** Fulfilled when the first scene of the table is shown. */
export const prepare = (): Promise<unknown> => shownFirst;
export { camera, farol, figure, webgl };
