/** Microshaders exchanged in place: a shader joined of pieces with a name, a header and a main part (thesis 3.1.2, 3.2.6). */
import { MicroShaderRegistry, WebGLShaderCompiler } from '@farol/renderer/microshaders';
import {
  CanvasTexture,
  Color,
  type IUniform,
  Matrix3,
  Mesh,
  PlaneGeometry,
  RawShaderMaterial,
  SphereGeometry,
  TorusKnotGeometry,
  Vector3,
} from 'three';
import thesisXML from '../../../../public/microshaders/thesis.xml?raw';
import { Figure } from './frame/Figure';
import extraXML from './microshaders/extra.xml?raw';

const figure = new Figure({ from: [0, 3, 6.4], at: [0, 0.7, 0], fov: 38, farol: { technique: 'forward-single-pass' } });
const { scene, farol, camera, webgl, controls } = figure;
const say = figure.say.bind(figure);
figure.describe(
  'Bodies on a floor, by a shader that is joined of microshaders',
  'Cuerpos sobre un suelo, con un shader unido de microshaders',
);

const gl = webgl.getContext() as WebGL2RenderingContext;
const registry = new MicroShaderRegistry(null, { compiler: new WebGLShaderCompiler(gl) });
await registry.loadXML(thesisXML, 'thesis.xml');
await registry.loadXML(extraXML, 'extra.xml');

/** The reader's choices; their names are those of microshaders. */
const chosen = { light: 'light_directional', model: 'phong' };
const fragmentOf = (): string[] => ['surface', 'light', chosen.light, chosen.model, 'lighting_output'];

const checker = document.createElement('canvas');
checker.width = checker.height = 64;
const pen = checker.getContext('2d')!;
for (let i = 0; i < 64; i++) {
  pen.fillStyle = (i + Math.floor(i / 8)) % 2 ? '#c9b48a' : '#efe6d0';
  pen.fillRect((i % 8) * 8, Math.floor(i / 8) * 8, 8, 8);
}
const uniforms: Record<string, IUniform> = {
  normalMatrixWS: { value: new Matrix3() },
  colorMap: { value: new CanvasTexture(checker) },
  materialAmbient: { value: new Color(1, 1, 1) },
  materialDiffuse: { value: new Color(0.85, 0.85, 0.85) },
  materialSpecular: { value: new Color(0.7, 0.7, 0.7) },
  materialShininess: { value: 40 },
  lightAmbient: { value: new Color(0.12, 0.12, 0.14) },
  lightDiffuse: { value: new Color(1, 0.95, 0.85) },
  lightSpecular: { value: new Color(1, 1, 1) },
  lightIntensity: { value: 1.1 },
  lightPositionWS: { value: new Vector3(1.6, 2.6, 1.4) },
  lightFrontWS: { value: new Vector3(-0.5, -1, -0.5) },
  lightNear: { value: 0.8 },
  lightFar: { value: 7 },
  spotCutoffCosine: { value: 0.82 },
  spotExponent: { value: 12 },
};
const floor = new Mesh(new PlaneGeometry(7, 7));
floor.rotation.x = -Math.PI / 2;
const knot = new Mesh(new TorusKnotGeometry(0.62, 0.22, 128, 24));
knot.position.set(-1.1, 1.1, 0);
const ball = new Mesh(new SphereGeometry(0.85, 48, 32));
ball.position.set(1.2, 0.85, 0);
const bodies = [floor, knot, ball];
scene.add(...bodies);

const source = document.createElement('pre');
source.tabIndex = 0;
source.setAttribute('aria-label', say('The fragment shader that was joined', 'El fragment shader unido'));
const editor = document.createElement('textarea');
editor.rows = 4;
editor.spellcheck = false;
editor.setAttribute(
  'aria-label',
  say('Main part of the light’s microshader', 'Parte principal del microshader de la luz'),
);

/** Composes the chosen pieces and puts the shader on every body. */
function compose(): void {
  const fragment = fragmentOf();
  // also compiles the program, or finds one compiled before under the same name
  registry.getShader(fragment.join('+'), ['transform'], fragment);
  const { vertexShader, fragmentShader } = registry.compose(['transform'], fragment);
  const precision = 'precision highp float;\n';
  for (const body of bodies) {
    (body.material as RawShaderMaterial).dispose();
    body.material = new RawShaderMaterial({
      uniforms,
      vertexShader: precision + vertexShader,
      fragmentShader: precision + fragmentShader,
    });
    body.updateMatrixWorld(true);
  }
  source.textContent = fragmentShader;
  editor.value = registry.get(chosen.light)!.main.trim();
}
figure.drawFrame = () => {
  for (const body of bodies)
    body.onBeforeRender = () => void (uniforms.normalMatrixWS.value as Matrix3).getNormalMatrix(body.matrixWorld);
  farol.render(scene, camera);
};

controls.choice({
  name: 'light',
  label: say('Light', 'Luz'),
  value: 'light_directional',
  options: ['light_directional', 'light_point', 'light_spot'].map((name) => [name, name] as const),
  change(value) {
    chosen.light = value;
    compose();
    tell();
  },
});
controls.choice({
  name: 'model',
  label: say('Model', 'Modelo'),
  value: 'phong',
  options: ['phong', 'lambert', 'toon'].map((name) => [name, name] as const),
  change(value) {
    chosen.model = value;
    compose();
    tell();
  },
});
controls.range({
  name: 'shininess',
  label: 'materialShininess',
  value: 40,
  min: 2,
  max: 200,
  change: (value) => void (uniforms.materialShininess.value = value),
});
function tell(): void {
  const pieces = fragmentOf().join(' + ');
  figure.tell(
    `Vertex: transform. Fragment: ${pieces}. Change the light’s main part below: a piece that does not compile is refused, with its line.`,
    `Vértices: transform. Fragmentos: ${pieces}. Cambie abajo la parte principal de la luz: si no compila se rechaza, con su línea.`,
  );
}
editor.addEventListener('input', () => {
  const piece = registry.get(chosen.light)!;
  try {
    registry.replace(chosen.light, { ...piece, main: `${editor.value}\n` });
    const text = editor.value;
    compose();
    editor.value = text;
    tell();
  } catch (error) {
    const { message } = error as Error;
    figure.tell(message, message);
  }
  figure.redraw();
});
figure.strip.append(editor, source);

export { camera, farol, figure, registry, scene, webgl };
