import { addClip, eased, track } from './clips';
import { addCamera, light, mesh } from './parts';
import { SampleScene } from './SampleScene';

const models = [
  ['Flat', 'flat'],
  ['Gouraud', 'gouraud'],
  ['Phong', 'smooth'],
] as const;

/** Flat, Gouraud and Phong shading side by side, on spheres of 80 triangles; thesis 2.2.1.2. */
export function shading(): Promise<SampleScene> {
  const scene = new SampleScene('Shading models');
  Object.assign(scene.settings, { background: 'colour', backgroundColour: [0.012, 0.015, 0.022] });
  addCamera(scene, [0, 1.7, 6.4], [0, 0.95, 0], { fov: 0.62 });
  scene.object('Floor', { scale: [30, 1, 30] }, mesh('plane', { colour: [0.2, 0.21, 0.23], roughness: 0.9 }));
  models.forEach(([name, value], i) => {
    const look = {
      kind: 'phong',
      colour: [0.75, 0.16, 0.08],
      specular: [0.6, 0.6, 0.6],
      shininess: 28,
      shading: value,
      receiveShadow: false,
    } as const;
    scene.object(name, { position: [(i - 1) * 2.2, 1, 0], scale: [15, 15, 15] }, mesh('bulb', look));
  });
  const way = addClip(scene, 'Lamp to and fro', 6, [
    track('', 'Transform.position', eased([0, [2.6, 4.2, 5]], [3, [-2.6, 4.2, 5]], [6, [2.6, 4.2, 5]])),
  ]);
  scene.object(
    'Lamp',
    { position: [2.6, 4.2, 5] },
    light('point', { diffuse: [1, 0.95, 0.88], intensity: 70, range: 20, castShadow: true }),
    ['Animation', { clip: way }],
  );
  scene.object('Fill', {}, ['Light', { type: 'hemisphere', diffuse: [0.5, 0.6, 0.8], intensity: 0.35 }]);
  return Promise.resolve(scene);
}
