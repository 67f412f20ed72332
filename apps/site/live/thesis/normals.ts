/** The atrium without normals, with normals averaged over every edge, and with a crease angle (thesis 4.1, 4.3). */
import { AssetLibrary } from '@farol/engine';
import { registerSceneAssets, sponza } from '@farol/scenes';
import { BufferAttribute, type BufferGeometry, Mesh, MeshNormalMaterial, MeshStandardMaterial } from 'three';
import { Figure } from './frame/Figure';
import { lookAsScene } from './frame/showScene';

const figure = new Figure({ from: [0, 2, 4], at: [0, 2, 0], pixelRatio: 1 });
const { farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe('An atrium of arcades', 'Un atrio con arcadas');

const assets = new AssetLibrary();
registerSceneAssets(assets);
const scene = await sponza(20, { assets, textureSize: 128, still: true });
scene.update(0);
scene.three.updateMatrixWorld(true);

const stone = new MeshStandardMaterial({ color: 0xb4a894, roughness: 0.8 });
const asColours = new MeshNormalMaterial();
/** Each mesh of the atrium, with the name of its asset without normals. */
const meshes: { mesh: Mesh; name: string; flat: BufferGeometry }[] = [];
const bare = new Map<BufferGeometry, { name: string; flat: BufferGeometry }>();
scene.three.traverse((object) => {
  const mesh = object as Mesh;
  if (
    !mesh.isMesh ||
    !mesh.geometry.hasAttribute('normal') ||
    !(mesh.material as MeshStandardMaterial).isMeshStandardMaterial
  )
    return;
  let known = bare.get(mesh.geometry);
  if (known === undefined) {
    const name = `bare/${bare.size}`;
    const geometry = mesh.geometry.clone().deleteAttribute('normal');
    assets.registerMaker(name, 'mesh', () => geometry);
    const flat = geometry.clone();
    const up = new Float32Array(3 * geometry.attributes.position.count);
    for (let i = 1; i < up.length; i += 3) up[i] = 1;
    flat.setAttribute('normal', new BufferAttribute(up, 3));
    bare.set(mesh.geometry, (known = { name, flat }));
  }
  meshes.push({ mesh, ...known });
});
lookAsScene(figure, scene, 12);

let angle = 36;
type Way = 'none' | 'smooth' | 'crease';
let way = 'smooth' as Way;
let showsNormals = false;
function apply(): void {
  const radians = way === 'smooth' ? Math.PI : (angle * Math.PI) / 180;
  for (const { mesh, name, flat } of meshes) {
    mesh.geometry = way === 'none' ? flat : assets.mesh(name, radians);
    mesh.material = showsNormals ? asColours : stone;
  }
}
figure.drawFrame = () => farol.render(scene.three, camera);
controls.choice<Way>({
  name: 'normals',
  label: say('Normals', 'Normales'),
  value: 'smooth',
  options: [
    ['none', say('none', 'ninguna')],
    ['smooth', say('over every edge', 'sobre toda arista')],
    ['crease', say('by crease angle', 'por ángulo')],
  ],
  change(value) {
    way = value;
    apply();
    if (value === 'none')
      figure.tell(
        'No normals in the file: every vertex reads the same constant, and relief is gone.',
        'Sin normales en el fichero: cada vértice lee la misma constante y el relieve desaparece.',
      );
    else if (value === 'smooth')
      figure.tell(
        'One normal a vertex, the mean of all its faces: right angles are shaded as if they were round. The stripes and lozenges of the thesis.',
        'Una normal por vértice, media de todas sus caras: los ángulos rectos se sombrean como si fueran redondos. Las franjas y los rombos de la tesis.',
      );
    else
      figure.tell(
        'Cured: faces share a normal only where they meet at less than the crease angle.',
        'Corregido: las caras comparten normal sólo si se encuentran con menos del ángulo de pliegue.',
      );
  },
});
controls.range({
  name: 'angle',
  label: say('Crease angle', 'Ángulo de pliegue'),
  value: 36,
  min: 0,
  max: 180,
  step: 12,
  format: (value) => `${value}°`,
  change(value) {
    angle = value;
    apply();
  },
});
controls.check({
  name: 'colours',
  label: say('As colours', 'Como colores'),
  value: false,
  change(on) {
    showsNormals = on;
    apply();
  },
});

export { camera, farol, figure, webgl };
