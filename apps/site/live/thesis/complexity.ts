/** Objects × lights against objects + lights, counted in the frame (thesis 2.2.2, 2.2.3.2, 2.2.4). */
import type { TechniqueName } from '@farol/renderer';
import { AmbientLight, Color, IcosahedronGeometry, Mesh, MeshPhongMaterial, PlaneGeometry } from 'three';
import { Figure } from './frame/Figure';
import { lamps } from './frame/room';

const figure = new Figure({ from: [0, 7, 9.5], at: [0, 0, 0.4], farol: { technique: 'deferred' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'Left of the middle the frame by forward rendering, right of it by deferred shading',
  'A la izquierda el fotograma por forward rendering, a la derecha por deferred shading',
);
const stone = new MeshPhongMaterial({ color: 0xb8b4ac, specular: 0x202020 });
const floor = new Mesh(new PlaneGeometry(11, 11), stone);
floor.rotation.x = -Math.PI / 2;
const shape = new IcosahedronGeometry(0.42, 3);
const bodies = Array.from({ length: 36 }, (_, i) => {
  const material = new MeshPhongMaterial({ color: new Color().setHSL((i * 0.382) % 1, 0.25, 0.55), shininess: 50 });
  const body = new Mesh(shape, material);
  scene.add(body);
  return body;
});
const { group, lights, move } = lamps(50, 14, 3);
scene.add(floor, group, new AmbientLight(0xffffff, 0.1));

let objects = 0;
let count = 0;
const table = document.createElement('table');
figure.strip.append(table);

const sides = [
  ['forward', 'Forward, multipass', 'Forward, multipasada'],
  ['deferred', 'Deferred shading', 'Deferred shading'],
] as const satisfies readonly (readonly [TechniqueName, string, string])[];

figure.drawFrame = () => {
  const rows = sides.map(([technique, english, spanish], i) => {
    farol.technique = technique;
    figure.inStripe(i / 2, 0.5, () => farol.render(scene, camera));
    const { passes } = farol.info;
    const of = (...names: string[]): number =>
      passes.reduce((sum, pass) => sum + (names.includes(pass.name) ? pass.drawCalls : 0), 0);
    const surfaces = of('multipass lights', 'g-buffer');
    const lighting = of('light volumes');
    const formula =
      technique === 'forward'
        ? `${objects} × ${count} = ${objects * count}`
        : `${objects} + ${count} = ${objects + count}`;
    return `<tr><th>${say(english, spanish)}</th><td>${formula}</td><td>${surfaces}</td><td>${lighting}</td></tr>`;
  });
  figure.label([
    { text: 'Forward', x: 0.25, y: 0.02 },
    { text: 'Deferred', x: 0.75, y: 0.02 },
  ]);
  const heads = [
    say('Technique', 'Técnica'),
    say('Thesis’s formula', 'Fórmula de la tesis'),
    say('Draws of surfaces', 'Dibujos de superficies'),
    say('Draws of light volumes', 'Dibujos de volúmenes de luz'),
  ];
  table.innerHTML = `<tr>${heads.map((head) => `<th>${head}</th>`).join('')}</tr>${rows.join('')}`;
};
controls.range({
  name: 'objects',
  label: say('Objects', 'Objetos'),
  value: 5,
  min: 1,
  max: 37,
  change(value) {
    objects = value;
    const side = Math.ceil(Math.sqrt(value - 1));
    bodies.forEach((body, i) => {
      body.visible = i < value - 1;
      body.position.set((i % side) - (side - 1) / 2, 0.25, Math.floor(i / side) - (side - 1) / 2).multiplyScalar(1.6);
      body.position.y = 0.42;
    });
  },
});
controls.range({
  name: 'lights',
  label: say('Lights', 'Luces'),
  value: 5,
  min: 1,
  max: 50,
  change(value) {
    count = value;
    lights.forEach((light, i) => (light.visible = i < value));
  },
});
figure.lampSliders({ label: say('Range (m)', 'Alcance (m)'), value: 14, min: 1, max: 14, step: 0.5 }, lights, move);
figure.tell(
  'Forward draws each object again for every light that reaches it. Deferred draws each object once, and all volumes of a kind in one call. Shorten the range: Farol’s multipass leaves out what no light reaches.',
  'Forward dibuja cada objeto otra vez por cada luz que lo alcanza. Deferred dibuja cada objeto una vez y todos los volúmenes de un tipo en una llamada. Acorte el alcance: la multipasada de Farol omite lo que ninguna luz alcanza.',
);

export { camera, farol, figure, scene, webgl };
