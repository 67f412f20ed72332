/** Phong's model term by term: ambient, diffuse and specular light, and their sum (thesis 2.2.1.1). */
import {
  Color,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  PointLight,
  SphereGeometry,
  TorusKnotGeometry,
} from 'three';
import { Figure } from './frame/Figure';

const figure = new Figure({ from: [0, 1.1, 5.6], at: [0, 0, 0], fov: 35, farol: { technique: 'forward-single-pass' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'Four pictures of a knot: ambient light alone, diffuse, specular, and the sum of the three',
  'Cuatro imágenes de un nudo: sólo luz ambiente, difusa, especular, y la suma de las tres',
);

const material = new MeshPhongMaterial();
scene.add(new Mesh(new TorusKnotGeometry(0.95, 0.36, 160, 32), material));
const lamp = new PointLight(0xffffff, 1, 0, 0);
lamp.add(new Mesh(new SphereGeometry(0.06, 16, 12), new MeshBasicMaterial({ color: 0xfff2c0 })));
scene.add(lamp);

/** The material's factors of the three kinds of reflection, and the lamp's colour. */
const factors = { ambient: new Color(0x2a3a66), diffuse: new Color(0x4169c8), specular: new Color(0xffffff) };
const strengths = { ambient: 1, diffuse: 1, specular: 0.6 };
type Term = keyof typeof strengths;
const sum: Record<Term, boolean> = { ambient: true, diffuse: true, specular: true };

/** Sets lights and material so that only these terms are left: three's light sums them as Phong's formula does. */
function set(terms: Record<Term, boolean>): void {
  // diffuse: light times colour over π, which three's light of intensity π makes up for
  lamp.intensity = Math.PI;
  material.color.copy(factors.diffuse).multiplyScalar(terms.diffuse ? strengths.diffuse : 0);
  material.specular.copy(factors.specular).multiplyScalar(terms.specular ? strengths.specular : 0);
  // the ambient term as light that the material gives off: independent of the diffuse factor, as in Phong's model
  material.emissive.copy(factors.ambient).multiplyScalar(terms.ambient ? strengths.ambient : 0);
}

const alone = (term: Term) => ({ ambient: false, diffuse: false, specular: false, [term]: true }) as typeof sum;
const draw = (terms: typeof sum) => () => {
  set(terms);
  farol.render(scene, camera);
};
const names: Record<Term, string> = {
  ambient: say('Ambient', 'Ambiente'),
  diffuse: say('Diffuse', 'Difusa'),
  specular: say('Specular', 'Especular'),
};
figure.drawFrame = () =>
  figure.panels([
    ...(['ambient', 'diffuse', 'specular'] as const).map((term) => ({ text: names[term], draw: draw(alone(term)) })),
    { text: say('Sum', 'Suma'), draw: draw(sum) },
  ]);

for (const term of ['ambient', 'diffuse', 'specular'] as const) {
  controls.check({ name: term, label: names[term], value: true, change: (on) => void (sum[term] = on) });
  controls.range({
    name: `${term}-strength`,
    label: `k ${names[term].toLowerCase()}`,
    value: strengths[term],
    min: 0,
    max: 1.5,
    step: 0.05,
    change: (value) => void (strengths[term] = value),
  });
}
controls.range({
  name: 'shininess',
  label: say('Shininess', 'Brillo'),
  value: 30,
  min: 1,
  max: 200,
  change: (value) => void (material.shininess = value),
});
controls.range({
  name: 'range',
  label: say('Light ends at (m)', 'La luz acaba a (m)'),
  value: 12,
  min: 2,
  max: 12,
  step: 0.5,
  format: (value) => (value === 12 ? '∞' : String(value)),
  change: (value) => {
    lamp.distance = value === 12 ? 0 : value;
    lamp.decay = value === 12 ? 0 : 1;
  },
});
controls.range({
  name: 'angle',
  label: say('Lamp', 'Lámpara'),
  value: 40,
  min: -180,
  max: 180,
  format: (value) => `${value}°`,
  change: (value) => {
    const angle = (value * Math.PI) / 180;
    lamp.position.set(2.3 * Math.sin(angle), 1.5, 2.3 * Math.cos(angle));
  },
});
figure.tell(
  'The first three pictures add up to the fourth, in linear light, pixel by pixel.',
  'Las tres primeras imágenes suman la cuarta, en luz lineal, píxel a píxel.',
);

export { alone, camera, farol, figure, scene, set, webgl };
