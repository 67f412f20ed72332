import { isWhole } from '@farol/tools/extent';
import { expect, test } from '../support/benchTest';

/** A lit particle and, in its place, a white rectangle that faces the camera as its middle does: linear colours. */
test('lit particles: environment, probes, ambient, hemisphere and area lights as a surface of three has them @verify', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate((isWhole) => {
    const { Bench, effects, oneParticle, setLightOptions, three } = window.testPage;
    const [width, height] = [32, 32];
    const bench = new Bench(width, height);
    bench.farol.effects = [new effects.Particles()];
    const camera = new three.PerspectiveCamera(40, 1, 0.1, 30);
    camera.position.set(1.5, 1, 3);
    camera.lookAt(0, 0, 0);
    const plain = new three.DataTexture(new Uint8Array([255, 255, 255, 255]), 1, 1);
    plain.needsUpdate = true;
    const emitter = oneParticle({ texture: plain, initialRotation: [0, 2 * Math.PI], lit: true });
    emitter.step(0.03);
    // particles have no specular light; three's Lambert material takes nothing of area lights
    const lambert = new three.MeshLambertMaterial();
    const physical = new three.MeshPhysicalMaterial({ specularIntensity: 0, roughness: 1 });
    const surface = new three.Mesh<InstanceType<typeof three.PlaneGeometry>, InstanceType<typeof three.Material>>(
      new three.PlaneGeometry(1, 1),
    );
    surface.quaternion.copy(camera.quaternion);
    const middle = ({ data }: { data: Float32Array }) => {
      const at = 4 * ((height / 2) * width + width / 2);
      return [0, 1, 2].map(
        (c) => (data[at + c] + data[at + c - 4] + data[at + c - 4 * width] + data[at + c - 4 * width - 4]) / 4,
      );
    };
    const probe = new three.LightProbe();
    probe.sh.coefficients.forEach((c, i) => i < 4 && c.set(0.5 - 0.1 * i, 0.3 + 0.05 * i, 0.1 * i));
    const hemisphere = new three.HemisphereLight(0x88aaff, 0x553311, 2);
    hemisphere.position.set(1, 2, 0.5);
    const area = (shape: 'rectangle' | 'disc' | 'tube') => {
      const light = new three.RectAreaLight(0xffddbb, 6, 1.2, shape === 'tube' ? 0.1 : 1.2);
      light.position.copy(camera.position);
      light.lookAt(0, 0, 0);
      setLightOptions(light, { shape });
      return light;
    };
    const colours = [0xff4422, 0x112244, 0x88aaff, 0x443322, 0x88ff66, 0x222222];
    const room = new three.Scene().add(
      new three.Mesh(
        new three.BoxGeometry(4, 4, 4),
        colours.map((color) => new three.MeshBasicMaterial({ color, side: three.BackSide })),
      ),
    );
    const environment = new three.PMREMGenerator(bench.webgl).fromScene(room, 0, 0.1, 100, { size: 64 }).texture;
    const scenes: Record<string, (scene: InstanceType<typeof three.Scene>) => void> = {
      ambient: (scene) => scene.add(new three.AmbientLight(0x335577, 2)),
      hemisphere: (scene) => scene.add(hemisphere),
      'light probe': (scene) => scene.add(probe),
      environment(scene) {
        scene.environment = environment;
        scene.environmentIntensity = 0.7;
        scene.environmentRotation.y = 0.6;
      },
      rectangle: (scene) => scene.add(area('rectangle')),
      disc: (scene) => scene.add(area('disc')),
      tube: (scene) => scene.add(area('tube')),
    };
    const found: { name: string; wanted: number[]; billboard: number[]; lists: number[]; mesh: number[] }[] = [];
    const others = isWhole ? [] : ['hemisphere', 'disc', 'tube'];
    for (const [name, fill] of Object.entries(scenes).filter(([name]) => !others.includes(name))) {
      const scene = new three.Scene();
      scene.background = new three.Color(0, 0, 0);
      fill(scene);
      const draw = (technique: 'forward-single-pass' | 'clustered-deferred') =>
        middle(bench.byTechnique(technique, scene, camera));
      scene.add(surface);
      const byFarol = ['rectangle', 'disc', 'tube'].includes(name);
      surface.material = byFarol ? physical : lambert;
      const wanted = byFarol ? draw('forward-single-pass') : middle(bench.stock(scene, camera));
      scene.remove(surface);
      scene.add(emitter);
      emitter.render = 'billboard';
      emitter.step(0);
      const billboard = draw('forward-single-pass');
      const lists = draw('clustered-deferred');
      // a mesh of one face towards the camera
      const face = new three.PlaneGeometry(1, 1).applyQuaternion(camera.quaternion);
      emitter.set({ render: 'mesh', particleGeometry: face, initialRotation: [0, 0] });
      const mesh = draw('forward-single-pass');
      scene.remove(emitter);
      found.push({ name, wanted, billboard, lists, mesh });
    }
    return found;
  }, isWhole);
  for (const { name, wanted, billboard, lists, mesh } of seen) {
    expect(Math.max(...wanted), name).toBeGreaterThan(0.01);
    // spherical harmonics of second order stand for an environment map
    const near = name === 'environment' ? 0.03 : 0.004;
    for (const [look, colour] of Object.entries({ billboard, lists, mesh }))
      colour.forEach((value, c) => expect(Math.abs(value - wanted[c]), `${name}, ${look}`).toBeLessThan(near));
  }
});
