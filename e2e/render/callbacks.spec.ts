import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('what callbacks of the host change while a frame is drawn counts for the frame as in stock three', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, brokenScene, compareImages, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { webgl } = bench;
    webgl.shadowMap.enabled = true;
    const { scene, camera, ball, box, lamp, spot, toon, ground, glass } = brokenScene(64, 48);
    glass.removeFromParent();
    scene.fog = new three.Fog(0x8899aa, 4, 30);
    const late = new three.PointLight(0x00ff00, 30, 8);
    late.position.set(-2, 1, 2);
    const cone = new three.Mesh(new three.ConeGeometry(0.5, 1), new three.MeshStandardMaterial({ color: 0x3355ff }));
    cone.position.set(0.4, 1.3, 1);
    const other = new three.MeshStandardMaterial({ color: 0xff2222 });
    const plain = new three.MeshStandardMaterial({ color: 0x44ff44 });
    const material = box.material as typeof plain;
    const shared = { 'scene.onBeforeRender': scene, 'object.onBeforeRender': box } as const;
    /** Changes that callbacks make, each with its undo. */
    const changes: Record<string, [() => void, () => void]> = {
      'a light’s colour': [() => lamp.color.set(0x0044ff), () => lamp.color.set(0xff8844)],
      'a light’s intensity': [() => (spot.intensity = 5), () => (spot.intensity = 60)],
      'a light’s position': [() => lamp.position.set(-2, 0, 2), () => lamp.position.set(2, 1, 2)],
      'a light’s place': [
        () => (lamp.position.set(-2, 0, 2), lamp.updateMatrixWorld()),
        () => (lamp.position.set(2, 1, 2), lamp.updateMatrixWorld()),
      ],
      'a light hidden': [() => (lamp.visible = false), () => (lamp.visible = true)],
      'a light added': [() => (scene.add(late), late.updateMatrixWorld()), () => scene.remove(late)],
      'a light removed': [() => scene.remove(spot), () => scene.add(spot)],
      'a light that casts no shadow': [() => (spot.castShadow = false), () => (spot.castShadow = true)],
      'an object added': [() => (scene.add(cone), cone.updateMatrixWorld()), () => scene.remove(cone)],
      'an object removed': [() => scene.remove(toon), () => scene.add(toon)],
      'an object hidden': [() => (ball.visible = false), () => (ball.visible = true)],
      'an object moved': [
        () => (ball.position.set(0.5, 0.5, 0), ball.updateMatrixWorld()),
        () => (ball.position.set(0, 0, 0), ball.updateMatrixWorld()),
      ],
      'the camera': [
        () => (camera.position.set(1, 1, 5.4), camera.updateMatrixWorld()),
        () => (camera.position.set(0, 1, 6), camera.updateMatrixWorld()),
      ],
      'the projection': [
        () => ((camera.fov = 30), camera.updateProjectionMatrix()),
        () => ((camera.fov = 50), camera.updateProjectionMatrix()),
      ],
      'the background': [() => (scene.background = new three.Color(0x335577)), () => (scene.background = null)],
      'the fog': [
        () => (scene.fog as InstanceType<typeof three.Fog>).color.set(0xff0000),
        () => (scene.fog as InstanceType<typeof three.Fog>).color.set(0x8899aa),
      ],
      'the override material': [() => (scene.overrideMaterial = plain), () => (scene.overrideMaterial = null)],
      'a material’s colour': [() => material.color.set(0xff00ff), () => material.color.set(0x88ff88)],
      'a material': [() => (box.material = other), () => (box.material = material)],
      'what the ground receives': [() => (ground.receiveShadow = false), () => (ground.receiveShadow = true)],
    };
    /** Changes by an object's callback that count for objects drawn after it. */
    const ordered = [
      'an object moved',
      'the override material',
      'the camera',
      'the projection',
      'the fog',
      'what the ground receives',
    ];
    const techniques = window.testPage.techniquesInTurn(1, [
      'forward',
      'forward-plus',
      'clustered-deferred',
      'light-prepass',
    ]);
    const results: { name: string; technique: string; difference: ReturnType<typeof compareImages> }[] = [];
    for (const [where, place] of Object.entries(shared)) {
      for (const [name, [change, back]] of Object.entries(changes)) {
        if (place === box && ordered.includes(name)) continue;
        const draw = (by: () => ReturnType<typeof bench.stock>) => {
          back();
          place.onBeforeRender = () => change();
          const image = by();
          place.onBeforeRender = three.Object3D.prototype.onBeforeRender;
          back();
          return image;
        };
        const stock = draw(() => bench.stock(scene, camera));
        for (const technique of techniques) {
          const difference = compareImages(
            stock,
            draw(() => bench.byTechnique(technique, scene, camera)),
          );
          results.push({ name: `${where}: ${name}`, technique, difference });
        }
      }
    }
    return results;
  });
  for (const { name, technique, difference } of results) {
    test.info().annotations.push({ type: name, description: `${technique} ${difference.psnr}` });
    expect.soft(() => checkAgreement(technique, difference, name), name).not.toThrow();
  }
});

test('the callbacks of a scene are called once a frame, as by stock three, and may end the renderer', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, brokenScene, three } = window.testPage;
    const bench = new Bench(32, 24);
    const { webgl } = bench;
    const { scene, camera, ball, glass } = brokenScene(32, 24);
    glass.removeFromParent(); // three keeps a target for it
    const half = (x: number) => Object.assign(camera.clone(), { viewport: new three.Vector4(x, 0, 16, 24) });
    const cameras = [camera, new three.ArrayCamera([half(0), half(16)] as never)];
    let calls: unknown[] = [];
    scene.onBeforeRender = function (this: unknown, ...all: unknown[]) {
      calls.push([
        'before',
        this === scene,
        ...all.map((one) => [webgl, scene, ...cameras, bench.target].indexOf(one as never)),
      ]);
    };
    scene.onAfterRender = function (this: unknown, ...all: unknown[]) {
      calls.push(['after', this === scene, ...all.map((one) => [webgl, scene, ...cameras].indexOf(one as never))]);
    };
    const called = cameras.map((by) => {
      const [stock, drawn] = [() => bench.stock(scene, by), () => bench.byTechnique('deferred', scene, by)].map(
        (draw) => {
          calls = [];
          draw();
          return JSON.stringify(calls);
        },
      );
      return { stock, drawn };
    });
    // ended by callbacks of a scene, of an object, and while an array of cameras draws
    const ends = [scene, ball].flatMap((place) =>
      cameras.map((by) => {
        const one = new window.testPage.farol.FarolRenderer(webgl, {
          technique: 'deferred',
        });
        place.onBeforeRender = () => one.dispose();
        const { textures } = webgl.info.memory;
        let message = '';
        try {
          one.render(scene, by);
          one.render(scene, by);
        } catch (error) {
          message = String(error);
        }
        place.onBeforeRender = () => undefined;
        return { message, left: webgl.info.memory.textures - textures };
      }),
    );
    return { called, ends };
  });
  for (const { stock, drawn } of results.called) expect(drawn).toBe(stock);
  for (const { message, left } of results.ends) {
    expect.soft(message).toMatch(/render\(\) after dispose/);
    expect.soft(left, 'textures left').toBe(0);
  }
});

test('a lit ShaderMaterial of cloned light uniforms is drawn by stock three and by Farol in turn', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, drawn, techniquesInTurn, three } = window.testPage;
    const bench = new Bench(48, 36);
    const { webgl } = bench;
    webgl.shadowMap.enabled = true;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(50, 48 / 36, 0.1, 20);
    camera.position.z = 4;
    const { lambert, phong } = three.ShaderLib;
    const make = ({ vertexShader, fragmentShader, uniforms }: typeof lambert, transparent: boolean) =>
      new three.ShaderMaterial({
        uniforms: three.UniformsUtils.merge([
          three.UniformsLib.lights,
          uniforms,
          { diffuse: { value: new three.Color(0xffaa66) } },
        ]),
        vertexShader,
        fragmentShader,
        lights: true,
        transparent,
      });
    [lambert, phong].forEach((shader, i) => {
      const ball = new three.Mesh(new three.SphereGeometry(0.8), make(shader, i === 1));
      ball.position.x = i * 2 - 1;
      scene.add(ball);
    });
    const spot = new three.SpotLight(0x8888ff, 30);
    spot.position.set(-1, 2, 3);
    spot.castShadow = true;
    const point = new three.PointLight(0xff4444, 10);
    point.position.set(1, -1, 2);
    const sun = new three.DirectionalLight(0xffffff, 1);
    scene.add(spot, point, sun, new three.HemisphereLight(0xffffff, 0x222222, 0.2));
    const names = techniquesInTurn(0, drawn);
    const stock = bench.stock(scene, camera);
    return names.map((name) => {
      const by = bench.byTechnique(name, scene, camera);
      const again = compareImages(stock, bench.stock(scene, camera)).largest;
      const inTurn = bench.byTechnique(name, scene, camera);
      const difference = Math.min(compareImages(stock, by).psnr, compareImages(stock, inTurn).psnr);
      return { name, difference, again };
    });
  });
  for (const { name, difference, again } of results) {
    expect.soft(difference, name).toBeGreaterThan(name === 'inferred' ? 35 : 60);
    expect.soft(again, `${name}: stock three in turn`).toBe(0);
  }
});
