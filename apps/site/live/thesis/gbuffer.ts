/** The G-buffer taken apart (thesis 2.2.3.1, 2.2.3.3.1, 3.1.1, 4.1). */
import { AmbientLight, DirectionalLight } from 'three';
import { BufferView } from './buffers/BufferView';
import { Figure } from './frame/Figure';
import { lamps, room } from './frame/room';

const figure = new Figure({ from: [3.6, 3.4, 7.2], at: [0, 1, 0] });
const { scene, farol, camera, webgl, controls } = figure;
const sun = new DirectionalLight(0xfff2e0, 0.7);
sun.position.set(3, 6, 4);
const { group, move } = lamps(24);
scene.add(room(), group, sun, new AmbientLight(0x8090b0, 0.35));
figure.describe('A room, and the buffers that it is lit from', 'Una habitación y los búferes con que se ilumina');

const view = new BufferView();
view.depths.set(3, 16);
farol.effects = [view];
const say = figure.say.bind(figure);
const words: Record<
  'albedo' | 'normal' | 'depth' | 'specular' | 'shininess' | 'ambient' | 'lighting' | 'final',
  readonly [string, string]
> = {
  albedo: [
    'RGBA8: square root of the diffuse colour; alpha: kind of surface',
    'RGBA8: raíz del color difuso; alfa: tipo de superficie',
  ],
  normal: [
    'RG16F: view-space normal on an octahedron, shown as XYZ',
    'RG16F: normal en el espacio de la cámara, en un octaedro; se muestra XYZ',
  ],
  depth: [
    '32 bits: distance along the view, near black, far white',
    '32 bits: distancia a la cámara, cerca negro, lejos blanco',
  ],
  specular: ['RGBA8: specular colour and strength', 'RGBA8: color especular y su fuerza'],
  shininess: [
    '16F, alpha of the accumulation: shininess (Phong exponent)',
    '16F, alfa de la acumulación: brillo (exponente de Phong)',
  ],
  ambient: [
    'RGB16F: ambient and emissive light, the accumulation that lights are added to',
    'RGB16F: luz ambiente y emisiva, la acumulación a la que se suman las luces',
  ],
  lighting: [
    'RGBA16F: all lights together, before ambient light',
    'RGBA16F: todas las luces juntas, sin la luz ambiente',
  ],
  final: [
    'The picture: lights read the buffers, not the objects',
    'La imagen: las luces leen los búferes, no los objetos',
  ],
};
controls.choice<keyof typeof words>({
  name: 'buffer',
  label: '',
  value: 'albedo',
  options: [
    ['albedo', say('Diffuse', 'Difuso')],
    ['normal', say('Normal', 'Normal')],
    ['depth', say('Depth', 'Profundidad')],
    ['specular', say('Specular', 'Especular')],
    ['shininess', say('Shininess', 'Brillo')],
    ['ambient', say('Accumulation', 'Acumulación')],
    ['lighting', say('Light', 'Luz')],
    ['final', say('Picture', 'Imagen')],
  ],
  change(name) {
    view.show = name === 'final' ? null : name;
    figure.tell(...words[name]);
  },
});
controls.range({
  name: 'from',
  label: say('Lay over the picture', 'Sobre la imagen'),
  value: 0,
  min: 0,
  max: 1,
  step: 0.01,
  format: (share) => `${Math.round(100 * (1 - share))} %`,
  change: (share) => void (view.from = share),
});
controls.choice({
  name: 'channel',
  label: say('Channel', 'Canal'),
  value: '-1',
  options: [
    ['-1', 'RGB'],
    ['0', 'R'],
    ['1', 'G'],
    ['2', 'B'],
  ],
  change: (channel) => void (view.channel = Number(channel)),
});
figure.animate(move);

export { camera, farol, figure, scene, webgl };
