/** The depth buffer while objects are drawn one after another, with the depth test and without (thesis 2.2.3.1.1). */
import type { View } from '@farol/renderer';
import { AmbientLight, DirectionalLight, type Material, type Mesh } from 'three';
import { Figure } from './frame/Figure';
import { room } from './frame/room';

const figure = new Figure({
  from: [3.6, 3.4, 7.2],
  at: [0, 1, 0],
  near: 2,
  far: 16,
  farol: { technique: 'forward-single-pass' },
});
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'On the left the objects drawn so far, on the right the depth buffer',
  'A la izquierda los objetos dibujados hasta ahora, a la derecha el búfer de profundidad',
);
const objects = room();
const sun = new DirectionalLight(0xffffff, 2);
sun.position.set(3, 6, 4);
scene.add(objects, sun, new AmbientLight(0xffffff, 0.6));
const meshes = objects.children as Mesh[];
const names: Record<string, string> = {
  floor: say('floor', 'suelo'),
  'back wall': say('back wall', 'pared del fondo'),
  'side wall': say('side wall', 'pared lateral'),
  ball: say('ball', 'bola'),
  column: say('column', 'columna'),
  box: say('box', 'caja'),
  knot: say('knot', 'nudo'),
};
type Order = 'listed' | 'near' | 'far';
let order: Order = 'far';
let count = 7;
let tests = true;
let view: View = 'depth';
farol.heatMapMaximum = 7;

figure.drawFrame = () => {
  const distance = (mesh: Mesh): number => mesh.getWorldPosition(mesh.position.clone()).distanceTo(camera.position);
  const sorted = [...meshes];
  if (order !== 'listed') sorted.sort((a, b) => (distance(a) - distance(b)) * (order === 'near' ? 1 : -1));
  sorted.forEach((mesh, i) => {
    mesh.renderOrder = i + 1;
    mesh.visible = i < count;
    (mesh.material as Material).depthTest = tests;
  });
  const show = (one: View) => () => {
    farol.view = one;
    farol.render(scene, camera);
  };
  const last = names[sorted[count - 1].name];
  figure.panels([
    { text: `${say('Drawn last', 'Último dibujado')}: ${last}`, draw: show('final') },
    {
      text: view === 'depth' ? say('Depth', 'Profundidad') : say('Shadings a pixel', 'Sombreados por píxel'),
      draw: show(view),
    },
  ]);
};
controls.range({
  name: 'count',
  label: say('Objects drawn', 'Objetos dibujados'),
  value: 7,
  min: 1,
  max: 7,
  change: (value) => void (count = value),
});
controls.choice<Order>({
  name: 'order',
  label: say('Order', 'Orden'),
  value: 'far',
  options: [
    ['far', say('far first', 'lejos primero')],
    ['near', say('near first', 'cerca primero')],
    ['listed', say('as listed', 'tal cual')],
  ],
  change: (value) => void (order = value),
});
controls.check({
  name: 'test',
  label: say('Depth test', 'Depth test'),
  value: true,
  change(on) {
    tests = on;
    if (on)
      figure.tell(
        'A fragment is kept where it is nearer than what the depth buffer holds; the order changes the work, not the picture.',
        'Un fragmento se queda si está más cerca que lo que guarda el búfer; el orden cambia el trabajo, no la imagen.',
      );
    else
      figure.tell(
        'Without the test whatever is drawn last covers all, however far away it is.',
        'Sin la prueba, lo último que se dibuja lo tapa todo, por lejos que esté.',
      );
  },
});
controls.choice<View>({
  name: 'view',
  label: say('Right', 'Derecha'),
  value: 'depth',
  options: [
    ['depth', say('depth', 'profundidad')],
    ['overdraw', say('work', 'trabajo')],
  ],
  change: (value) => void (view = value),
});

export { camera, farol, figure, scene, webgl };
