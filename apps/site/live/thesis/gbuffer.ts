/** The G-buffer taken apart (thesis 2.2.3.1, 2.2.3.3.1, 3.1.1, 4.1). */
import { AmbientLight, DirectionalLight } from 'three';
import { BufferView } from './buffers/BufferView';
import { GBufferProbe } from './buffers/GBufferProbe';
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
const probe = new GBufferProbe();
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

const table = document.createElement('table');
const heads = ['R', 'G', 'B', 'A', say('target', 'destino')];
table.innerHTML = `<tr>${heads.map((head) => `<th>${head}</th>`).join('')}</tr>`;
/** Rows of the table, with the number of channels that each target has. */
const rows = (
  [
    [1, say('depth 32F', 'profundidad 32F')],
    [4, say('RT0 16F: accumulation RGB, shininess', 'RT0 16F: acumulación RGB, brillo')],
    [2, say('RT1 16F: normal, folded', 'RT1 16F: normal, plegada')],
    [4, say('RT2 8: specular RGB, strength', 'RT2 8: especular RGB, fuerza')],
    [4, say('RT3 8: √ diffuse RGB, kind of surface', 'RT3 8: √ difuso RGB, tipo de superficie')],
  ] as const
).map(([channels, name]) => {
  const row = table.insertRow();
  for (let i = 0; i < 4; i++) row.insertCell();
  row.insertCell().textContent = name;
  return { row, channels };
});
figure.strip.append(table);
figure.drawFrame = () => {
  farol.render(scene, camera);
  // the probe's program is compiled only after the first picture is shown
  if (farol.effects.length === 1) {
    farol.effects = [view, probe];
    figure.redraw();
  }
  figure.label([{ text: '+', x: probe.place.x, y: 0.98 - probe.place.y }]);
  void probe.read(webgl, (values) =>
    rows.forEach(({ row, channels }, r) => {
      for (let i = 0; i < channels; i++) row.cells[i].textContent = values[4 * r + i].toFixed(r === 0 ? 6 : 3);
    }),
  );
};
webgl.domElement.addEventListener('pointermove', ({ offsetX, offsetY }) => {
  const { clientWidth, clientHeight } = webgl.domElement;
  probe.place.set(offsetX / clientWidth, 1 - offsetY / clientHeight);
  figure.redraw();
});
figure.animate(move);

export { camera, farol, figure, scene, webgl };
