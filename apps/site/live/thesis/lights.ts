/** The three kinds of light over one room, and ambient light (thesis 2.2.1 and the picture of 2.2.1.3). */
import {
  AmbientLight,
  CylinderGeometry,
  DirectionalLight,
  type Light,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  PlaneGeometry,
  PointLight,
  SphereGeometry,
  SpotLight,
} from 'three';
import { Figure } from './frame/Figure';

const figure = new Figure({ from: [0.7, 2.9, 8.4], at: [0, 1.5, 0], farol: { technique: 'forward-single-pass' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'A room of planes with a ball in the air and a cylinder, under a directional, a red point and a white spot light',
  'Una habitación de planos con una bola en el aire y un cilindro, bajo una luz direccional, una puntual roja y un foco blanco',
);
webgl.shadowMap.enabled = true;

const wall = new MeshPhongMaterial({ color: 0xb4aca0, shininess: 8, specular: 0x101010 });
const plane = (width: number, height: number, x: number, y: number, z: number, turnX: number, turnY: number) => {
  const mesh = new Mesh(new PlaneGeometry(width, height), wall);
  mesh.position.set(x, y, z);
  mesh.rotation.set(turnX, turnY, 0);
  mesh.receiveShadow = true;
  scene.add(mesh);
};
plane(9, 8, 0, 0, 0, -Math.PI / 2, 0);
plane(9, 5, 0, 2.5, -4, 0, 0);
plane(8, 5, -4.5, 2.5, 0, 0, Math.PI / 2);
plane(8, 5, 4.5, 2.5, 0, 0, -Math.PI / 2);
const ball = new Mesh(
  new SphereGeometry(0.8, 48, 32),
  new MeshPhongMaterial({ color: 0xc0c0c8, specular: 0xc0c0c0, shininess: 90 }),
);
ball.position.set(-2.1, 2.7, -1.2);
const cylinder = new Mesh(
  new CylinderGeometry(0.7, 0.7, 2.2, 40),
  new MeshPhongMaterial({ color: 0xc6b27e, specular: 0x303030 }),
);
cylinder.position.set(2.5, 1.1, -0.8);
for (const mesh of [ball, cylinder]) mesh.castShadow = mesh.receiveShadow = true;

const ambient = new AmbientLight(0xffffff, 0.3);
const sun = new DirectionalLight(0xfff4e0, 2.2);
const point = new PointLight(0xff2a1c, 14, 6.5);
point.position.set(-2.2, 1.3, 0.6);
point.add(new Mesh(new SphereGeometry(0.07, 16, 12), new MeshBasicMaterial({ color: 0xff6050 })));
const spot = new SpotLight(0xffffff, 160, 14, 0.4, 0.4);
spot.position.set(-1.2, 5, 3.4);
spot.target.position.set(1.5, 0, 1.6);
Object.assign(sun.shadow.camera, { left: -7, right: 7, top: 7, bottom: -7 });
scene.add(ball, cylinder, ambient, sun, point, spot, spot.target);

const lights: [string, Light, string][] = [
  ['ambient', ambient, say('Ambient', 'Ambiente')],
  ['directional', sun, say('Directional', 'Direccional')],
  ['point', point, say('Point', 'Puntual')],
  ['spot', spot, say('Spot', 'Foco')],
];
for (const [name, light, label] of lights)
  controls.check({ name, label, value: true, change: (on) => void (light.visible = on) });
controls.range({
  name: 'sun',
  label: say('Direction', 'Dirección'),
  value: -40,
  min: -80,
  max: 80,
  format: (value) => `${value}°`,
  change(value) {
    const angle = (value * Math.PI) / 180;
    sun.position.set(8 * Math.sin(angle), 7, 4 * Math.cos(angle));
  },
});
controls.range({
  name: 'range',
  label: say('Range of the point (m)', 'Alcance de la puntual (m)'),
  value: 6.5,
  min: 1,
  max: 10,
  step: 0.1,
  change: (value) => void (point.distance = value),
});
controls.range({
  name: 'cone',
  label: say('Cone', 'Cono'),
  value: 23,
  min: 5,
  max: 60,
  format: (value) => `${value}°`,
  change: (value) => void (spot.angle = (value * Math.PI) / 180),
});
controls.range({
  name: 'edge',
  label: say('Soft edge', 'Borde suave'),
  value: 0.4,
  min: 0,
  max: 1,
  step: 0.05,
  change: (value) => void (spot.penumbra = value),
});
controls.check({
  name: 'shadows',
  label: say('Shadows (5.1)', 'Sombras (5.1)'),
  value: false,
  change: (on) => [sun, point, spot].forEach((light) => (light.castShadow = on)),
});
figure.tell(
  'Directional: parallel rays, one shade on a plane. Point: it fades with distance and ends at its range. Spot: the same within a cone.',
  'Direccional: rayos paralelos, un tono por plano. Puntual: se atenúa con la distancia y acaba en su alcance. Foco: lo mismo dentro de un cono.',
);

export { camera, farol, figure, scene, webgl };
