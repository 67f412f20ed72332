/** The engine's design: a scene of objects, each with components that may be switched off (thesis 3.1, 3.2.1 to 3.2.5, 3.3.1). */
import { Camera, type Component, GameObject, Light, ObjectRenderer, RandomMovement, Scene } from '@farol/engine';
import type { TechniqueName } from '@farol/renderer';
import { Color } from 'three';
import { Figure } from './frame/Figure';

const figure = new Figure({ from: [0, 3.2, 7.5], at: [0, 0.8, 0] });
const { farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe('A scene of game objects', 'Una escena de GameObjects');

const scene = new Scene({ name: 'Thesis' });
scene.three.background = new Color(0x0b0d12);
/** An object of the scene, or of another object. */
function object(
  name: string,
  place: { position?: [number, number, number]; scale?: [number, number, number] },
  parent?: GameObject,
): GameObject {
  const one = new GameObject(name);
  if (place.position) one.transform.position = place.position;
  if (place.scale) one.transform.scale = place.scale;
  (parent ?? scene).add(one);
  return one;
}
const eye = object('Camera', {});
eye.addComponent(Camera, { fov: 0.8 });
eye.transform.lookAt([0, 3.2, 7.5], [0, 0.8, 0]);
object('Floor', { scale: [9, 1, 9] }).addComponent(ObjectRenderer, {
  mesh: 'plane',
  colour: [0.6, 0.6, 0.62],
  roughness: 0.7,
});
const planet = object('Planet', { position: [0, 1.3, 0], scale: [1.8, 1.8, 1.8] });
planet.addComponent(ObjectRenderer, { mesh: 'sphere', colour: [0.75, 0.45, 0.3], roughness: 0.5 });
const moon = object('Moon', { position: [1.1, 0, 0], scale: [0.3, 0.3, 0.3] }, planet);
moon.addComponent(ObjectRenderer, { mesh: 'sphere', colour: [0.8, 0.8, 0.85], roughness: 0.6 });
const lamp = object('Lamp', { position: [-1.8, 2.6, 1.6] });
lamp.addComponent(Light, { type: 'point', diffuse: [1, 0.85, 0.6], intensity: 16, range: 9 });
lamp.addComponent(ObjectRenderer, { mesh: 'bulb', kind: 'basic', colour: [1, 0.85, 0.6] });
lamp.addComponent(RandomMovement, { seed: 4, extent: [1, 0.3, 1], speed: 1 });
const sky = object('Sky', {});
sky.addComponent(Light, { type: 'ambient', intensity: 0.25 });

/** A checkbox that switches a component, or a whole object with its children. */
function box(name: string, label: string, part: Component | GameObject): HTMLLabelElement {
  const input = document.createElement('input');
  Object.assign(input, { type: 'checkbox', name, checked: true });
  // this switch has no visible effect while the scene stands still
  if (part instanceof RandomMovement) input.dataset.moves = '';
  input.addEventListener('change', () => {
    if (part instanceof GameObject) part.active = input.checked;
    else part.enabled = input.checked;
    figure.redraw();
  });
  const words = document.createElement('label');
  words.append(input, label);
  return words;
}
function listOf(objects: readonly GameObject[]): HTMLUListElement {
  const list = document.createElement('ul');
  for (const one of objects) {
    const row = document.createElement('li');
    row.append(one.getComponent(Camera) ? one.name : box(one.name, one.name, one), ' · Transform');
    for (const part of one.components)
      if (part.typeName !== 'Transform' && part.typeName !== 'Camera')
        row.append(' ', box(`${one.name}.${part.typeName}`, part.typeName, part));
    if (one.getComponent(Camera)) row.append(' · Camera');
    if (one.children.length > 0) row.append(listOf(one.children));
    list.append(row);
  }
  return list;
}
let time = 0;
figure.drawFrame = () => farol.render(scene.three, camera);
controls.choice<TechniqueName>({
  name: 'technique',
  label: say('Technique', 'Técnica'),
  value: 'forward-single-pass',
  options: [
    ['forward-single-pass', 'Forward'],
    ['deferred', 'Deferred'],
  ],
  change: (value) => void (farol.technique = value),
});
controls.range({
  name: 'turn',
  label: say('Turn the planet', 'Girar el planeta'),
  value: 0,
  min: 0,
  max: 355,
  step: 5,
  format: (value) => `${value}°`,
  change: (value) => void (planet.transform.rotation = [0, (value * Math.PI) / 180, 0]),
});
figure.animate((seconds) => {
  scene.update(Math.max(0, seconds - time));
  time = seconds;
});
figure.strip.append(listOf(scene.roots));
figure.tell(
  'The scene updates its objects, each object its components and children: the moon turns with its planet. Switch parts off.',
  'La escena actualiza sus objetos, y cada objeto sus componentes e hijos: la luna gira con su planeta. Apague partes.',
);
scene.update(0);

export { camera, farol, figure, webgl };
