/** 2.5D culling of Forward+: one tile's lights by its frustum, by its depth bounds, by its occupied slices (thesis 2.2.3.3.5). */
import {
  AmbientLight,
  BufferAttribute,
  BufferGeometry,
  Color,
  DirectionalLight,
  DoubleSide,
  LineBasicMaterial,
  LineLoop,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PerspectiveCamera,
  Plane,
  Raycaster,
  SphereGeometry,
  Vector2,
  Vector3,
  WireframeGeometry,
} from 'three';
import { Figure } from './frame/Figure';
import { lamps, room } from './frame/room';

/** Number of slices of a tile's depth range, a bit of one 32-bit word each (Harada 2012). */
const SLICES = 32;
/** Layer of what only the view from the side shows. */
const SIDE_LAYER = 1;
/** Number of points along a side of the tile at which depth is sampled. */
const SAMPLES = 8;

const figure = new Figure({ from: [3.6, 3, 7.2], at: [0, 1, 0], far: 30, farol: { technique: 'clustered-forward' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'On the left the picture with one tile, on the right that tile’s frustum from above, with its lights',
  'A la izquierda la imagen con una celda, a la derecha el frustum de la celda desde arriba, con sus luces',
);
const objects = room();
const { group, lights, move } = lamps(60, 0.6, 1.5);
const sun = new DirectionalLight(0xffffff, 0.8);
sun.position.set(3, 6, 4);
scene.add(objects, group, sun, new AmbientLight(0xffffff, 0.35));

const above = new PerspectiveCamera(45, 1, 0.1, 60);
above.layers.enable(SIDE_LAYER);
const kept = {
  out: new Color(0x555b66),
  frustum: new Color(0xe0503c),
  bounds: new Color(0xf0c040),
  mask: new Color(0x50d070),
};
const wire = new WireframeGeometry(new SphereGeometry(1, 8, 5));
const spheres = lights.map((light) => {
  const sphere = new LineSegments(wire, new LineBasicMaterial({ transparent: true, opacity: 0.8 }));
  sphere.layers.set(SIDE_LAYER);
  light.add(sphere);
  return sphere;
});
const edges = new LineSegments(new BufferGeometry(), new LineBasicMaterial({ color: 0xffffff }));
const slices = new Mesh(
  new BufferGeometry(),
  new MeshBasicMaterial({ color: 0x60a8ff, transparent: true, opacity: 0.3, side: DoubleSide, depthWrite: false }),
);
for (const one of [edges, slices]) {
  one.layers.set(SIDE_LAYER);
  one.frustumCulled = false;
  scene.add(one);
}

/** Outline of the tile, seen in the picture alone. */
const outline = new LineLoop(new BufferGeometry(), new LineBasicMaterial({ color: 0xffb454, depthTest: false }));
outline.frustumCulled = false;
scene.add(outline);

const place = new Vector2(-0.1, 0.02);
let half = 0.1;

/** Corner of the tile at a distance along the view (m), world space; `x` and `y` are -1 or 1. */
function corner(x: number, y: number, distance: number): Vector3 {
  const ray = new Vector3(place.x + x * half, place.y + y * half * camera.aspect, 0.5)
    .unproject(camera)
    .sub(camera.position)
    .normalize();
  return ray.multiplyScalar(distance / ray.dot(forward)).add(camera.position);
}
const forward = new Vector3();
const around = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
] as const;

/** Distances along the view (m) of what the tile sees. */
function depthsOfTile(): number[] {
  const ray = new Raycaster();
  const found: number[] = [];
  for (let i = 0; i < SAMPLES * SAMPLES; i++) {
    const [x, y] = [(2 * ((i % SAMPLES) + 0.5)) / SAMPLES - 1, (2 * (Math.floor(i / SAMPLES) + 0.5)) / SAMPLES - 1];
    ray.setFromCamera(new Vector2(place.x + x * half, place.y + y * half * camera.aspect), camera);
    const [hit] = ray.intersectObject(objects, true);
    if (hit) found.push(hit.point.sub(camera.position).dot(forward));
  }
  return found;
}

/** Finds which lights each of the three tests keeps, and shows tile, slices and lights from above. */
function cull(): void {
  camera.updateMatrixWorld();
  camera.getWorldDirection(forward);
  const depths = depthsOfTile();
  const [near, far] = [Math.min(...depths), Math.max(...depths) + 1e-3];
  const width = (far - near) / SLICES;
  let occupied = 0;
  for (const depth of depths) occupied |= 1 << Math.min(SLICES - 1, Math.floor((depth - near) / width));
  const planes = around.map((_, i) => {
    const [a, b] = [around[i], around[(i + 1) % 4]];
    return new Plane().setFromCoplanarPoints(camera.position, corner(b[0], b[1], 1), corner(a[0], a[1], 1));
  });
  const middle = corner(0, 0, 5);
  for (const plane of planes) if (plane.distanceToPoint(middle) < 0) plane.negate();
  const counts = { frustum: 0, bounds: 0, mask: 0 };
  const position = new Vector3();
  lights.forEach((light, i) => {
    const { distance: radius } = light;
    light.getWorldPosition(position);
    const away = position.clone().sub(camera.position).dot(forward);
    const inFrustum = planes.every((plane) => plane.distanceToPoint(position) > -radius) && away > -radius;
    const inBounds = inFrustum && depths.length > 0 && away + radius > near && away - radius < far;
    let mask = 0;
    for (let s = 0; s < SLICES; s++)
      if (away + radius > near + s * width && away - radius < near + (s + 1) * width) mask |= 1 << s;
    const inMask = inBounds && (mask & occupied) !== 0;
    counts.frustum += Number(inFrustum);
    counts.bounds += Number(inBounds);
    counts.mask += Number(inMask);
    spheres[i].material.color.copy(inMask ? kept.mask : inBounds ? kept.bounds : inFrustum ? kept.frustum : kept.out);
    spheres[i].material.opacity = inFrustum ? 0.9 : 0.12;
    spheres[i].scale.setScalar(radius);
  });
  showTile(near, width, occupied, depths.length > 0);
  figure.tell(
    `Of 60 lights the tile’s frustum keeps ${counts.frustum}, its depth bounds ${counts.bounds} (not the red), the mask of ${SLICES} slices ${counts.mask} (green; yellow ones lie in empty slices).`,
    `De 60 luces, el frustum de la celda deja ${counts.frustum}, sus límites de profundidad ${counts.bounds} (sin las rojas) y la máscara de ${SLICES} capas ${counts.mask} (verdes; las amarillas caen en capas vacías).`,
  );
}
function showTile(near: number, width: number, occupied: number, isFull: boolean): void {
  const points = around.flatMap(([x, y]) => [...camera.position.toArray(), ...corner(x, y, 14).toArray()]);
  edges.geometry.dispose();
  edges.geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(points), 3));
  const loop = around.flatMap(([x, y]) => corner(x, y, 1).toArray());
  outline.geometry.dispose();
  outline.geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(loop), 3));
  const faces: number[] = [];
  for (let s = isFull ? 0 : SLICES; s < SLICES; s++) {
    if (((occupied >>> s) & 1) === 0) continue;
    const [front, back] = [near + s * width, near + (s + 1) * width].map((d) =>
      around.map(([x, y]) => corner(x, y, d)),
    );
    for (let k = 0; k < 4; k++) {
      const [a, b, c, d] = [front[k], front[(k + 1) % 4], back[(k + 1) % 4], back[k]];
      for (const point of [a, b, c, a, c, d]) faces.push(...point.toArray());
    }
  }
  slices.geometry.dispose();
  slices.geometry = new BufferGeometry().setAttribute('position', new BufferAttribute(new Float32Array(faces), 3));
  above.position
    .copy(camera.position)
    .addScaledVector(forward, 6)
    .add(new Vector3(0, 11, 0));
  above.up.copy(forward).setY(0).normalize();
  above.lookAt(new Vector3().copy(camera.position).addScaledVector(forward, 6.2));
}
function drawAbove(): void {
  above.aspect = camera.aspect;
  above.updateProjectionMatrix();
  farol.render(scene, above);
}
figure.drawFrame = () => {
  figure.panels([
    {
      text: say('The tile in the picture', 'La celda en la imagen'),
      draw() {
        cull();
        outline.visible = true;
        farol.render(scene, camera);
        outline.visible = false;
      },
    },
    { text: say('Its frustum from above', 'Su frustum desde arriba'), draw: drawAbove },
  ]);
};
const tile = (name: 'x' | 'y', label: string): void => {
  controls.range({
    name,
    label,
    value: place[name],
    min: -0.8,
    max: 0.8,
    step: 0.02,
    format: (value) => value.toFixed(2),
    change: (value) => void (place[name] = value),
  });
};
tile('x', say('Tile x', 'Celda x'));
tile('y', say('Tile y', 'Celda y'));
controls.range({
  name: 'size',
  label: say('Size', 'Tamaño'),
  value: 0.1,
  min: 0.04,
  max: 0.3,
  step: 0.02,
  change: (value) => void (half = value),
});
figure.lampSliders(
  { label: say('Range of the lights (m)', 'Alcance de las luces (m)'), value: 0.6, min: 0.3, max: 3, step: 0.1 },
  lights,
  move,
);

export { camera, farol, figure, scene, webgl };
