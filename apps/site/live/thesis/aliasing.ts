/** A chessboard to the horizon: the aliasing of the thesis's picture, and what cures it (thesis 4.3). */
import type { FarolEffect } from '@farol/renderer';
import { SMAA } from '@farol/renderer/antialiasing';
import {
  AmbientLight,
  DataTexture,
  DirectionalLight,
  LinearFilter,
  LinearMipmapLinearFilter,
  Mesh,
  MeshPhongMaterial,
  NearestFilter,
  PlaneGeometry,
  RepeatWrapping,
  TorusGeometry,
} from 'three';
import { Figure } from './frame/Figure';

const figure = new Figure({ from: [0, 1.1, 4], at: [0, 0.75, 0], far: 400, pixelRatio: 1 });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe('A chessboard that goes to the horizon', 'Un tablero de ajedrez que llega al horizonte');

/** Texels of the chessboard's picture along a side, of two squares. */
const SIDE = 256;
const board = new DataTexture(new Uint8Array(4 * SIDE * SIDE), SIDE, SIDE);
const bytes = board.image.data as Uint8Array;
for (let i = 0; i < SIDE * SIDE; i++) {
  const white = i % SIDE < SIDE / 2 === Math.floor(i / SIDE) < SIDE / 2;
  bytes.set([white ? 235 : 20, white ? 235 : 20, white ? 230 : 24, 255], 4 * i);
}
Object.assign(board, { colorSpace: 'srgb', wrapS: RepeatWrapping, wrapT: RepeatWrapping, generateMipmaps: true });
board.repeat.set(150, 150);
const floor = new Mesh(new PlaneGeometry(300, 300), new MeshPhongMaterial({ map: board, specular: 0 }));
floor.rotation.x = -Math.PI / 2;
const ring = new Mesh(new TorusGeometry(0.6, 0.16, 24, 48), new MeshPhongMaterial({ color: 0xc8703c }));
ring.position.set(0, 0.9, 0);
const sun = new DirectionalLight(0xffffff, 2);
sun.position.set(2, 4, 3);
scene.add(floor, ring, sun, new AmbientLight(0xffffff, 0.6));

const filters = {
  nearest: [
    NearestFilter,
    1,
    'The nearest texel for each pixel: far squares are smaller than pixels, and patterns appear that are not there. The thesis’s picture.',
    'El téxel más próximo por píxel: los cuadros lejanos son menores que un píxel y aparecen dibujos que no existen. La imagen de la tesis.',
  ],
  linear: [
    LinearFilter,
    1,
    'Four texels blended: edges near by are soft, the horizon is as it was.',
    'Cuatro téxeles mezclados: los bordes cercanos se suavizan, el horizonte sigue igual.',
  ],
  mipmaps: [
    LinearMipmapLinearFilter,
    1,
    'Mipmaps: averaged copies for what is far away; no pattern, but the distance is grey too early.',
    'Mipmaps: copias promediadas para lo lejano; sin dibujos falsos, pero lo lejano se vuelve gris demasiado pronto.',
  ],
  anisotropic: [
    LinearMipmapLinearFilter,
    16,
    'Anisotropic mipmaps: as many samples as the slant asks for; squares stay squares to the horizon.',
    'Mipmaps anisótropos: tantas muestras como pide la inclinación; los cuadros siguen siendo cuadros hasta el horizonte.',
  ],
} as const;
controls.choice<keyof typeof filters>({
  name: 'filter',
  label: say('Texture', 'Textura'),
  value: 'nearest',
  options: [
    ['nearest', say('nearest', 'más próximo')],
    ['linear', 'linear'],
    ['mipmaps', 'mipmaps'],
    ['anisotropic', say('anisotropic', 'anisótropo')],
  ],
  change(name) {
    const [minFilter, anisotropy, english, spanish] = filters[name];
    board.magFilter = name === 'nearest' ? NearestFilter : LinearFilter;
    board.minFilter = minFilter;
    board.anisotropy = Math.min(anisotropy, webgl.capabilities.getMaxAnisotropy());
    board.needsUpdate = true;
    figure.tell(english, spanish);
  },
});
const edges: readonly FarolEffect[] = [new SMAA()];
controls.check({
  name: 'smaa',
  label: say('Smooth edges (SMAA)', 'Bordes suaves (SMAA)'),
  value: false,
  change: (on) => void (farol.effects = on ? edges : []),
});
controls.range({
  name: 'pixel',
  label: say('Size of a pixel', 'Tamaño del píxel'),
  value: 2,
  min: 1,
  max: 6,
  change(value) {
    webgl.setPixelRatio(1 / value);
    webgl.domElement.style.imageRendering = 'pixelated';
  },
});
controls.range({
  name: 'height',
  label: say('Height of the eye (m)', 'Altura del ojo (m)'),
  value: 1.1,
  min: 0.3,
  max: 6,
  step: 0.1,
  change(value) {
    camera.position.y = value;
    camera.lookAt(figure.orbit.target);
  },
});

export { camera, farol, figure, scene, webgl };
