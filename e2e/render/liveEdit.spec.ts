import { expect, test } from '../support/benchTest';

test('a microshader replaced while the scene runs changes the picture of every technique; a broken edit changes nothing', async ({
  benchPage: page,
}) => {
  const { results, both } = await page.evaluate(() => {
    const { authoring, Bench, compareImages, techniquesInTurn, three } = window.testPage;
    const bench = new Bench(80, 60);
    const scene = new three.Scene();
    const ball = new three.SphereGeometry(1, 16, 12);
    scene.add(new three.Mesh(ball, new three.MeshStandardMaterial({ roughness: 0.6 })).translateX(-1.1));
    scene.add(new three.Mesh(ball, new three.MeshPhongMaterial()).translateX(1.1));
    for (const x of [-3, 0, 3]) scene.add(new three.PointLight(0xffffff, 20, 8).translateX(x).translateZ(3));
    const camera = new three.PerspectiveCamera(40, 80 / 60, 0.1, 20);
    camera.position.z = 6;
    const name = 'lightAttenuation';
    const { microshaders } = bench.farol;
    const good = microshaders.get(name)!;
    const half = { ...good, header: good.header.replaceAll('return falloff;', 'return 0.5 * falloff;') };
    const broken = { ...good, header: good.header.replace('return falloff;', 'return fallof;') };
    const results = techniquesInTurn(1).map((technique) => {
      const before = bench.byTechnique(technique, scene, camera);
      let error: unknown = null;
      try {
        microshaders.replace(name, broken);
      } catch (caught) {
        error = caught;
      }
      const afterBroken = bench.byTechnique(technique, scene, camera);
      microshaders.replace(name, half);
      const afterHalf = bench.byTechnique(technique, scene, camera);
      microshaders.replace(name, good);
      const afterGood = bench.byTechnique(technique, scene, camera);
      return {
        technique,
        named: error instanceof authoring.MicroShaderCompileError ? error.entries[0] : null,
        message: String(error),
        broken: compareImages(before, afterBroken).largest,
        half: compareImages(before, afterHalf).largest,
        good: compareImages(before, afterGood).largest,
      };
    });
    // two edits before the next frame, the second of which needs the first
    const before = bench.byTechnique('tiled-deferred', scene, camera);
    const user = microshaders.get('addPoint')!;
    microshaders.replace(name, { ...good, header: `${good.header}\nfloat farol_half() { return 0.5; }\n` });
    const halved = user.header.replaceAll('farol_boundedAttenuation(', 'farol_half() * farol_boundedAttenuation(');
    microshaders.replace('addPoint', { ...user, header: halved });
    const both = compareImages(before, bench.byTechnique('tiled-deferred', scene, camera)).largest;
    return { results, both };
  });
  for (const { technique, named, message, broken, half, good } of results) {
    expect(named?.chunk, message).toBe('lightAttenuation');
    expect(named?.text, message).toContain('return fallof;');
    expect(broken, `${technique}: a broken edit`).toBe(0);
    expect(half, `${technique}: half the light`).toBeGreaterThan(0.05);
    expect(good, `${technique}: the first text again`).toBe(0);
  }
  expect(both, 'two edits at once').toBeGreaterThan(0.05);
});
