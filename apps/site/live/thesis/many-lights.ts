/** Three ways to have many lights: a pass a light, a loop over all in one shader, and a lightmap (thesis 2.2.1.3). */
import type { TechniqueName } from '@farol/renderer';
import { AmbientLight, Color, DataTexture, type Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { Figure } from './frame/Figure';
import { lamps, room } from './frame/room';

const figure = new Figure({ from: [3.6, 3.4, 7.2], at: [0, 1, 0], farol: { technique: 'forward-single-pass' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'A room under six lights, lit in three ways',
  'Una habitación bajo seis luces, iluminada de tres maneras',
);

const objects = room();
const ambient = new AmbientLight(0x8090b0, 0.4);
const { group, lights, move } = lamps(6, 6, 10);
scene.add(objects, group, ambient);

/** Texels of a lightmap along a side. */
const SIDE = 48;
const planes = ['floor', 'back wall', 'side wall'].map((name) => objects.getObjectByName(name) as Mesh);
const lit = planes.map(({ material }) => material);
const baked = planes.map((plane) => bake(plane));

/** Diffuse light of all lamps at each texel of a plane, as three's Lambert has it: computed once, on the CPU. */
function bake(plane: Mesh): MeshBasicMaterial {
  plane.updateWorldMatrix(true, false);
  const { width, height } = (plane.geometry as Mesh['geometry'] & { parameters: { width: number; height: number } })
    .parameters;
  const normal = new Vector3(0, 0, 1).transformDirection(plane.matrixWorld);
  const albedo = (plane.material as MeshBasicMaterial).color;
  const data = new Uint8Array(4 * SIDE * SIDE);
  const [place, toLight, light, sum] = [new Vector3(), new Vector3(), new Vector3(), new Color()];
  group.updateWorldMatrix(true, true);
  for (let i = 0; i < SIDE * SIDE; i++) {
    const [u, v] = [((i % SIDE) + 0.5) / SIDE, (Math.floor(i / SIDE) + 0.5) / SIDE];
    place.set((u - 0.5) * width, (v - 0.5) * height, 0).applyMatrix4(plane.matrixWorld);
    sum.copy(ambient.color).multiplyScalar(0.4);
    for (const one of lights) {
      toLight.subVectors(light.setFromMatrixPosition(one.matrixWorld), place);
      const distance = toLight.length();
      const window = Math.max(0, 1 - (distance / one.distance) ** 4) ** 2;
      const falloff =
        (10 * window * Math.max(0, toLight.normalize().dot(normal))) / Math.max(0.01, distance * distance);
      sum.r += one.color.r * falloff;
      sum.g += one.color.g * falloff;
      sum.b += one.color.b * falloff;
    }
    const { r, g, b } = sum
      .multiply(albedo)
      .multiplyScalar(1 / Math.PI)
      .convertLinearToSRGB();
    data.set(
      [r, g, b, 1].map((value) => Math.round(255 * Math.min(1, value))),
      4 * i,
    );
  }
  const map = new DataTexture(data, SIDE, SIDE);
  Object.assign(map, { colorSpace: 'srgb', minFilter: 1006, magFilter: 1006, needsUpdate: true });
  return new MeshBasicMaterial({ map });
}

type Way = 'multipass' | 'loop' | 'lightmap';
const techniques: Record<Way, TechniqueName> = {
  multipass: 'forward',
  loop: 'forward-single-pass',
  lightmap: 'forward-single-pass',
};
const texts: Record<Way, readonly [string, string]> = {
  multipass: [
    'Multipass: ambient light first, then a draw a light over what it reaches, added.',
    'Multipasada: primero la luz ambiente; después, un dibujo por luz sobre lo que alcanza, sumado.',
  ],
  loop: [
    'Several lights in a shader: each object once; its shader loops over all lights.',
    'Varias luces por shader: cada objeto una vez; su shader recorre todas las luces.',
  ],
  lightmap: [
    'Lightmaps: floor and walls show stored light and cost nothing. Move the lamps: what is stored stays, and nothing but the objects follows.',
    'Lightmaps: suelo y paredes muestran luz guardada y no cuestan nada. Mueva las lámparas: lo guardado se queda y sólo los objetos las siguen.',
  ],
};
let way: Way = 'loop';
figure.drawFrame = () => {
  farol.render(scene, camera);
  const draws = say(`${farol.info.drawCalls} draws.`, `${farol.info.drawCalls} dibujos.`);
  figure.tell(`${texts[way][0]} ${draws}`, `${texts[way][1]} ${draws}`);
};
controls.choice<Way>({
  name: 'way',
  label: '',
  value: 'loop',
  options: [
    ['multipass', say('Multipass', 'Multipasada')],
    ['loop', say('Loop in a shader', 'Bucle en un shader')],
    ['lightmap', 'Lightmap'],
  ],
  change(value) {
    way = value;
    farol.technique = techniques[value];
    planes.forEach((plane, i) => (plane.material = value === 'lightmap' ? baked[i] : lit[i]));
  },
});
controls.range({
  name: 'time',
  label: say('Move the lamps', 'Mover las lámparas'),
  value: 0,
  min: 0,
  max: 30,
  step: 0.5,
  change: move,
});

export { camera, farol, figure, scene, webgl };
