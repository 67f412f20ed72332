/** Flat, Gouraud and Phong shading under a slider (thesis 2.2.1.2). */
import { setShading, type ShadingName } from '@farol/renderer';
import {
  AmbientLight,
  type BufferGeometry,
  Mesh,
  MeshPhongMaterial,
  PointLight,
  SphereGeometry,
  TorusGeometry,
  WireframeGeometry,
  LineSegments,
  LineBasicMaterial,
} from 'three';
import { Figure } from './frame/Figure';

const figure = new Figure({ from: [0, 1.4, 5.4], at: [0, 0, 0], fov: 38, farol: { technique: 'forward-single-pass' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'A ring and a ball, drawn by flat, Gouraud and Phong shading',
  'Un anillo y una bola, dibujados con sombreado plano, de Gouraud y de Phong',
);

const names = ['flat', 'gouraud', 'phong'] as const satisfies readonly ShadingName[];
const materials = names.map((name) => {
  const material = new MeshPhongMaterial({ color: 0xc8703c, specular: 0x505050, shininess: 60 });
  setShading(material, name);
  return material;
});
const ring = new Mesh(new TorusGeometry(), materials[0]);
const ball = new Mesh(new SphereGeometry(), materials[0]);
const wires = [ring, ball].map(
  (mesh) =>
    new LineSegments<BufferGeometry>(
      mesh.geometry,
      new LineBasicMaterial({ color: 0x808890, transparent: true, opacity: 0.5 }),
    ),
);
const lamp = new PointLight(0xffffff, 22, 20);
scene.add(ring, ball, ...wires, lamp, new AmbientLight(0xffffff, 0.25));
ring.rotation.x = wires[0].rotation.x = -0.6;

/** Share of the picture that the next shading has: 0 all flat, 1 all Gouraud, 2 all Phong. */
let at = 1;
const draw = (i: number) => () => {
  ring.material = ball.material = materials[i];
  farol.render(scene, camera);
};
figure.drawFrame = () => {
  const first = Math.min(1, Math.floor(at));
  const share = at - first;
  if (share < 1) figure.inStripe(share, 1 - share, draw(first));
  if (share > 0) figure.inStripe(0, share, draw(first + 1));
  const titles = [say('flat', 'plano'), 'Gouraud', 'Phong'];
  figure.label([
    ...(share > 0.08 ? [{ text: titles[first + 1], x: share / 2, y: 0.02 }] : []),
    ...(share < 0.92 ? [{ text: titles[first], x: (1 + share) / 2, y: 0.02 }] : []),
  ]);
};

controls.range({
  name: 'at',
  label: say('Flat · Gouraud · Phong', 'Plano · Gouraud · Phong'),
  value: 0.5,
  min: 0,
  max: 2,
  step: 0.01,
  format: () => '',
  change(value) {
    at = value;
    if (value < 0.5)
      figure.tell(
        'Flat: the model once for a triangle, by its one normal.',
        'Plano: el modelo, una vez por triángulo, con su única normal.',
      );
    else if (value < 1.5)
      figure.tell(
        'Gouraud: the model at each vertex, its results interpolated; a highlight inside of a triangle is lost.',
        'Gouraud: el modelo en cada vértice y sus resultados interpolados; un brillo dentro de un triángulo se pierde.',
      );
    else
      figure.tell(
        'Phong: the normals are interpolated, the model is evaluated in each fragment.',
        'Phong: se interpolan las normales y el modelo se evalúa en cada fragmento.',
      );
  },
});
controls.range({
  name: 'detail',
  label: say('Triangles', 'Triángulos'),
  value: 12,
  min: 4,
  max: 48,
  format: (n) => String(n * n * 2 + 4 * n * n),
  change(n) {
    for (const mesh of [ring, ball, ...wires]) mesh.geometry.dispose();
    ring.geometry = new TorusGeometry(1.5, 0.42, n, 2 * n);
    ball.geometry = new SphereGeometry(0.72, n, n);
    wires[0].geometry = new WireframeGeometry(ring.geometry);
    wires[1].geometry = new WireframeGeometry(ball.geometry);
  },
});
controls.range({
  name: 'shininess',
  label: say('Shininess', 'Brillo'),
  value: 60,
  min: 2,
  max: 200,
  change: (value) => materials.forEach((material) => (material.shininess = value)),
});
controls.check({
  name: 'wires',
  label: say('Edges', 'Aristas'),
  value: false,
  change: (on) => wires.forEach((wire) => (wire.visible = on)),
});
figure.animate((seconds) => {
  lamp.position.set(2.2 * Math.sin(0.6 * seconds + 0.4), 2, 2.2 * Math.cos(0.6 * seconds + 0.4));
});

export { camera, farol, figure, scene, webgl };
