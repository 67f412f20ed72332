/** A programmable pipeline between vertices and a picture, stage by stage (thesis 2.2). */
import {
  AmbientLight,
  type BufferGeometry,
  DirectionalLight,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  Points,
  PointsMaterial,
  TorusKnotGeometry,
  WireframeGeometry,
} from 'three';
import { VertexNormalsHelper } from 'three/addons/helpers/VertexNormalsHelper.js';
import { Figure } from './frame/Figure';

const figure = new Figure({ from: [0, 1.2, 5], at: [0, 0, 0], fov: 40, farol: { technique: 'forward-single-pass' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe('A knot at one stage of the pipeline', 'Un nudo en una etapa de la pipeline');

const lit = new MeshPhongMaterial({ color: 0xc8703c, specular: 0x404040, shininess: 40 });
const plain = new MeshBasicMaterial({ color: 0xc8703c });
const knot = new Mesh<BufferGeometry>(new TorusKnotGeometry(), lit);
const points = new Points<BufferGeometry, PointsMaterial>(
  knot.geometry,
  new PointsMaterial({ color: 0xffb454, size: 4, sizeAttenuation: false }),
);
const wires = new LineSegments<BufferGeometry>(knot.geometry, new LineBasicMaterial({ color: 0x6aa0e0 }));
const sun = new DirectionalLight(0xffffff, 2.6);
sun.position.set(2, 3, 3);
/** Vertices as they are in their buffer. */
const stored = new TorusKnotGeometry(1, 0.34, 96, 14);
let normals: VertexNormalsHelper | null = null;
scene.add(knot, points, wires, sun, new AmbientLight(0xffffff, 0.3));

const stages = [
  [
    'vertices',
    say('Vertices', 'Vértices'),
    'Numbers in a buffer: positions, normals, texture coordinates. Nothing is a surface yet.',
    'Números en un búfer: posiciones, normales, coordenadas de textura. Aún no hay superficie.',
  ],
  [
    'transform',
    say('Vertex program', 'Programa de vértices'),
    'Each vertex by the model, view and projection matrices, here also bent by the slider.',
    'Cada vértice por las matrices Model, View y Projection; aquí, además, doblado por el control.',
  ],
  [
    'primitives',
    say('Primitives', 'Primitivas'),
    'Vertices joined to triangles; a geometry program, which WebGL lacks, could make more of them: here a line for each normal.',
    'Vértices unidos en triángulos; un programa de geometría, que WebGL no tiene, podría crear más: aquí, una línea por normal.',
  ],
  [
    'fragments',
    say('Rasterisation', 'Rasterización'),
    'Triangles cut into fragments, one for each pixel that they cover: pixels are enlarged here.',
    'Triángulos cortados en fragmentos, uno por píxel que cubren: aquí, con los píxeles ampliados.',
  ],
  [
    'shaded',
    say('Fragment program', 'Programa de fragmentos'),
    'A program gives each fragment its colour: lighting is evaluated here.',
    'Un programa da color a cada fragmento: aquí se evalúa la iluminación.',
  ],
  [
    'picture',
    say('Picture', 'Imagen'),
    'The nearest fragments stay: at full resolution, the picture.',
    'Quedan los fragmentos más próximos: a resolución completa, la imagen.',
  ],
] as const;
type Stage = (typeof stages)[number][0];
const resolution = Math.min(devicePixelRatio, 2);

const choose = controls.choice<Stage>({
  name: 'stage',
  label: '',
  value: 'vertices',
  options: stages.map(([name, label], i) => [name, `${i + 1}. ${label}`] as const),
  change(stage) {
    const at = stages.findIndex(([name]) => name === stage);
    points.visible = at < 2;
    // as they lie in the buffer, before the program has moved them
    points.geometry = at === 0 ? stored : knot.geometry;
    points.material.color.set(at === 0 ? 0x9098a8 : 0xffb454);
    wires.visible = at === 2;
    if (normals !== null) normals.visible = at === 2;
    knot.visible = at > 2;
    knot.material = stage === 'fragments' ? plain : lit;
    // fewer, larger pixels
    webgl.setPixelRatio(stage === 'fragments' || stage === 'shaded' ? resolution / 9 : resolution);
    webgl.domElement.style.imageRendering = 'pixelated';
    figure.tell(stages[at][2], stages[at][3]);
  },
});
controls.button('next', say('Next', 'Siguiente'), () => {
  const at = stages.findIndex(
    ([name]) => controls.element.querySelector<HTMLInputElement>(`[value="${name}"]`)!.checked,
  );
  choose(stages[(at + 1) % stages.length][0]);
});
controls.range({
  name: 'bend',
  label: say('Bend', 'Doblar'),
  value: 0.4,
  min: -1,
  max: 1,
  step: 0.05,
  change(bend) {
    knot.geometry.dispose();
    wires.geometry.dispose();
    const geometry = new TorusKnotGeometry(1, 0.34, 96, 14);
    const { position } = geometry.attributes;
    for (let i = 0; i < position.count; i++) {
      const [x, y, z] = [position.getX(i), position.getY(i), position.getZ(i)];
      const angle = bend * y;
      position.setXYZ(i, x * Math.cos(angle) - z * Math.sin(angle), y, x * Math.sin(angle) + z * Math.cos(angle));
    }
    geometry.computeVertexNormals();
    knot.geometry = geometry;
    if (points.geometry !== stored) points.geometry = geometry;
    wires.geometry = new WireframeGeometry(geometry);
    const wasShown = normals?.visible ?? false;
    normals?.removeFromParent();
    normals?.dispose();
    normals = new VertexNormalsHelper(knot, 0.12, 0xffb454);
    normals.visible = wasShown || wires.visible;
    scene.add(normals);
  },
});

export { camera, farol, figure, scene, webgl };
