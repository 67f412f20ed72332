import { expect, test } from '../support/benchTest';

test('500 lights added one by one, toggled and removed compile nothing, and none is dropped', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, fewMeshes, materialScene, techniquesInTurn, three } = window.testPage;
    const bench = new Bench(32, 24);
    return techniquesInTurn(4).map((technique) => {
      const { scene, camera, lights } = materialScene(32, 24, { count: 4, part: fewMeshes });
      bench.byTechnique(technique, scene, camera);
      // 'auto' compiles a technique when it first picks it: it has been through both ends before the count
      if (technique === 'auto') {
        const crowd = new three.Group();
        for (let i = 0; i < 500; i++) crowd.add(new three.PointLight(0xffffff, 0.1, 20));
        for (const many of [true, false]) {
          if (many) scene.add(crowd);
          else scene.remove(crowd);
          for (let frame = 0; frame < 10; frame++) bench.byTechnique(technique, scene, camera);
        }
        const few = lights.map((light) => light.visible);
        lights.forEach((light) => (light.visible = false));
        for (let frame = 0; frame < 10; frame++) bench.byTechnique(technique, scene, camera);
        lights.forEach((light, i) => (light.visible = few[i]));
        for (let frame = 0; frame < 10; frame++) bench.byTechnique(technique, scene, camera);
      }
      const before = bench.programs;
      const added: InstanceType<typeof three.Light>[] = [];
      const kinds = [
        () => new three.PointLight(0xffffff, 0.1, 20),
        () => new three.SpotLight(0xffffff, 0.1, 20, 0.4),
        () => new three.DirectionalLight(0xffffff, 0.001),
        () => new three.HemisphereLight(0xffffff, 0x000000, 0.001),
        () => new three.AmbientLight(0xffffff, 0.001),
      ];
      for (let i = 0; i < 500; i++) {
        const light = kinds[i % kinds.length]();
        light.position.set(Math.sin(i) * 3, Math.cos(i) * 2, 2);
        scene.add(light);
        added.push(light);
        if (i < 10 || i % 250 === 249) bench.byTechnique(technique, scene, camera);
      }
      const visible = bench.farol.info.lights.visible;
      for (const light of added) light.visible = false;
      bench.byTechnique(technique, scene, camera);
      for (const light of added) light.visible = true;
      bench.byTechnique(technique, scene, camera);
      for (const light of added) scene.remove(light);
      bench.byTechnique(technique, scene, camera);
      return { technique, compiled: bench.programs - before, visible, wanted: 500 + lights.length + 1 };
    });
  });
  for (const { technique, compiled, visible, wanted } of results) {
    expect(compiled, `${technique}: programs compiled`).toBe(0);
    expect(visible, `${technique}: lights drawn`).toBe(wanted);
  }
});

test('4,096 lights on a floor: nothing is dropped, every technique draws all of them', async ({ benchPage: page }) => {
  const results = await page.evaluate(() => {
    const { Bench, techniquesInTurn, three } = window.testPage;
    const bench = new Bench(128, 128);
    const camera = new three.OrthographicCamera(-8, 8, 8, -8, 0.1, 20);
    camera.position.z = 5;
    const scene = new three.Scene();
    scene.add(new three.Mesh(new three.PlaneGeometry(16, 16), new three.MeshLambertMaterial()));
    for (let i = 0; i < 4096; i++) {
      const light = new three.PointLight(0xffffff, 0.02, 0.25);
      light.position.set(((i % 64) + 0.5) / 4 - 8, (Math.floor(i / 64) + 0.5) / 4 - 8, 0.1);
      scene.add(light);
    }
    return techniquesInTurn(2).map((technique) => {
      const { data } = bench.byTechnique(technique, scene, camera);
      // two pixels a light: each light's cell of 2 × 2 pixels is lit alike, and a dropped light leaves its cell black
      const cells: number[] = [];
      for (let i = 0; i < 4096; i++) cells.push(data[4 * ((i % 64) * 2 + Math.floor(i / 64) * 2 * 128)]);
      const { visible } = bench.farol.info.lights;
      return { technique, darkest: Math.min(...cells), brightest: Math.max(...cells), visible };
    });
  });
  for (const { technique, darkest, brightest, visible } of results) {
    expect(visible, technique).toBe(4096);
    expect(darkest, `${technique}: darkest cell`).toBeGreaterThan(0.02);
    expect(brightest / darkest, `${technique}: brightest over darkest cell`).toBeLessThan(1.1);
  }
});

test('two FarolRenderers on one WebGLRenderer, whose shaders know other kinds of shadows, share no program of other text', async ({
  benchPage: page,
}) => {
  const apart = await page.evaluate(() => {
    const { Bench, compareImages, farol, three } = window.testPage;
    const bench = new Bench(64, 48);
    bench.webgl.shadowMap.enabled = true;
    const material = new three.MeshStandardMaterial({ roughness: 0.6 });
    const make = (
      light: InstanceType<typeof three.SpotLight | typeof three.PointLight | typeof three.DirectionalLight>,
    ) => {
      const scene = new three.Scene();
      const floor = new three.Mesh(new three.PlaneGeometry(8, 8), material);
      const ball = new three.Mesh(new three.SphereGeometry(0.7), material);
      ball.position.z = 1;
      floor.receiveShadow = ball.castShadow = light.castShadow = true;
      light.position.set(1.5, 2, 4);
      return scene.add(floor, ball, light);
    };
    const camera = new three.PerspectiveCamera(50, 4 / 3, 0.1, 30);
    camera.position.z = 7;
    const scenes = {
      spot: make(new three.SpotLight(0xffffff, 60)),
      sun: make(new three.DirectionalLight(0xffffff, 2)),
      point: make(new three.PointLight(0xffffff, 60)),
    };
    const results: Record<string, number> = {};
    for (const technique of ['forward-single-pass', 'clustered-deferred'] as const) {
      const others: InstanceType<typeof farol.FarolRenderer>[] = [];
      for (const [name, scene] of Object.entries(scenes)) {
        const one = new farol.FarolRenderer(bench.webgl, { technique });
        others.push(one);
        results[`${name}, ${technique}`] = compareImages(
          bench.stock(scene, camera),
          bench.draw(() => one.render(scene, camera)),
        ).psnr;
      }
      for (const other of others) other.dispose();
    }
    return results;
  });
  for (const [name, psnr] of Object.entries(apart)) expect(psnr, name).toBeGreaterThan(45);
});
