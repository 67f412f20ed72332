import { readFileSync } from 'node:fs';
import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';

const WIDTH = 128;
const HEIGHT = 96;

test.describe.configure({ timeout: 240_000 });

test('a surface that displaces and paints is what stock three draws of displaced geometries by the same formula; one that does nothing changes no bit', async ({
  benchPage: page,
}) => {
  const { results, some } = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, isFlat, surfaces, surfaceScene, techniquesInTurn } = window.testPage;
      const bench = new Bench(width, height);
      bench.webgl.shadowMap.enabled = true;
      const expected = surfaceScene(width, height, 'oracle');
      const stock = bench.stock(expected.scene, expected.camera);
      const [worn, none] = (['surface', 'none'] as const).map((wear) => surfaceScene(width, height, wear));
      const names = techniquesInTurn(1);
      const some = ['forward-single-pass', 'deferred', 'light-prepass'].filter((name) =>
        names.includes(name as 'auto'),
      );
      const text = 'void surface(inout SurfaceData s) {}\nvoid displace(inout VertexData v) {}';
      const nothing = new surfaces.Surface('nothing', text);
      const results = names.map((technique) => {
        const draw = ({ scene, camera }: typeof worn) => {
          bench.byTechnique(technique, scene, camera);
          return bench.byTechnique(technique, scene, camera);
        };
        const picture = draw(worn);
        // one technique of each sort: bits are the same by way of the same shaders
        if (!some.includes(technique))
          return { technique, flat: isFlat(stock), difference: compareImages(stock, picture) };
        const plain = draw(none);
        for (const material of none.materials) surfaces.setSurface(material, nothing);
        const same = draw(none);
        for (const material of none.materials) surfaces.setSurface(material, null);
        return {
          technique,
          flat: isFlat(stock),
          difference: compareImages(stock, picture),
          none: Math.max(compareImages(plain, same).largest, compareImages(plain, draw(none)).largest),
          changed: compareImages(plain, picture).share,
        };
      });
      return { results, some };
    },
    [WIDTH, HEIGHT] as const,
  );
  expect(some.length).toBeGreaterThan(1);
  expect(results.filter((result) => result.none === 0)).toHaveLength(some.length);
  for (const { technique, flat, difference, none, changed } of results) {
    expect(flat).toBe(false);
    checkAgreement(technique, difference, 'surfaces');
    expect.soft(none ?? 0, `${technique}: a surface that does nothing`).toBe(0);
    expect.soft(changed ?? 1, `${technique}: the surface shows`).toBeGreaterThan(0.05);
  }
});

test('what a surface moves by its time has motion and shadow as if the object moved', async ({ benchPage: page }) => {
  const result = await page.evaluate(() => {
    const { Bench, compareImages, effects, surfaces, three } = window.testPage;
    const pictures = [true, false].map((byTime) => {
      const bench = new Bench(96, 72);
      bench.webgl.shadowMap.enabled = true;
      bench.farol.effects = [new effects.TAA()];
      const scene = new three.Scene();
      const camera = new three.PerspectiveCamera(45, 96 / 72, 0.1, 20);
      camera.position.set(0, 1.5, 5);
      camera.lookAt(0, 0.3, 0);
      const material = new three.MeshStandardMaterial({ color: 0xff5500 });
      const mesh = new three.Mesh(new three.TorusGeometry(0.5, 0.2, 12, 24), material);
      mesh.position.y = 0.8;
      mesh.castShadow = mesh.receiveShadow = true;
      mesh.frustumCulled = false;
      const floor = new three.Mesh(
        new three.PlaneGeometry(8, 8).rotateX(-Math.PI / 2),
        new three.MeshStandardMaterial(),
      );
      floor.receiveShadow = true;
      const light = new three.SpotLight(0xffffff, 60, 12, 0.8, 0.5);
      light.position.set(1, 5, 3);
      light.castShadow = true;
      scene.add(mesh, floor, light, light.target, new three.AmbientLight(0x404040));
      const surface = new surfaces.Surface('slides', 'void displace(inout VertexData v) { v.positionOS.x += v.time; }');
      if (byTime) surfaces.setSurface(material, surface);
      let picture = null;
      for (let frame = 0; frame < 6; frame++) {
        if (byTime) surface.time.value = 0.125 * frame;
        else mesh.position.x = 0.125 * frame;
        picture = bench.byTechnique('deferred', scene, camera);
      }
      return picture!;
    });
    return compareImages(pictures[0], pictures[1]);
  });
  expect(result.psnr).toBeGreaterThan(50);
  expect(result.share).toBeLessThan(0.002);
});

const thesis = readFileSync(new URL('../../public/microshaders/thesis.xml', import.meta.url), 'utf8');

test("the thesis's chunks on an object draw its formula: ambient, diffuse and specular of a directional, point and spot light", async ({
  benchPage: page,
}) => {
  const worst = await page.evaluate((xml) => {
    const { authoring, Bench, surfaces, three } = window.testPage;
    const size = 24;
    const bench = new Bench(size, size);
    const scene = new three.Scene();
    const material = new three.MeshBasicMaterial();
    const normal = new three.Vector3(0.3, -0.2, 1).normalize();
    const plane = new three.PlaneGeometry(2, 2);
    for (let i = 0; i < 4; i++) plane.attributes.normal.setXYZ(i, ...normal.toArray());
    scene.add(new three.Mesh(plane, material));
    const camera = new three.OrthographicCamera(-1, 1, 1, -1, 0.1, 10);
    // vertices lie on corners of pixels, which rasterisers keep
    camera.position.set(0.25, -0.25, 3);
    const position = new three.Vector3(0.4, -0.2, 0.8);
    const front = new three.Vector3(-0.3, 0.2, -1);
    const values = {
      materialAmbient: [0.5, 0.25, 1],
      materialDiffuse: [0.75, 0.5, 0.25],
      materialSpecular: [1, 0.5, 0.5],
      materialShininess: 12,
      lightAmbient: [0.1, 0.2, 0.3],
      lightDiffuse: [1, 0.9, 0.8],
      lightSpecular: [0.5, 0.75, 1],
      lightIntensity: 1.5,
    };
    const ranged = { lightPositionWS: position.toArray(), lightNear: 0.5, lightFar: 2.5 };
    const own = {
      directional: { lightFrontWS: front.toArray() },
      point: ranged,
      spot: { ...ranged, lightFrontWS: front.toArray(), spotCutoffCosine: 0.85, spotExponent: 6 },
    };
    const chunks = authoring.parseMicroShaderXML(xml, 'thesis.xml');
    const worst: Record<string, number> = {};
    for (const light of ['directional', 'point', 'spot'] as const) {
      const names = ['surface', 'light', `light_${light}`, 'phong', 'phong_output'];
      const surface = new surfaces.Surface(light, surfaces.textOfMicroShaders(chunks, names));
      surfaces.setSurface(material, surface, { ...values, ...own[light] });
      for (const technique of ['forward-single-pass', 'deferred'] as const) {
        const { data } = bench.byTechnique(technique, scene, camera);
        let most = 0;
        for (let y = 0; y < size; y++) {
          for (let x = 0; x < size; x++) {
            // thesis 3.1.2 and 2.2.1.2: Phong, with the reflected vector
            const px = camera.position.x + ((x + 0.5) / size) * 2 - 1;
            const py = camera.position.y + ((y + 0.5) / size) * 2 - 1;
            if (Math.abs(px) > 1 || Math.abs(py) > 1) continue;
            const p = new three.Vector3(px, py, 0);
            const n = normal;
            const view = camera.position.clone().sub(p).normalize();
            const along = front.clone().normalize();
            const way = light === 'directional' ? along.clone().negate() : position.clone().sub(p).normalize();
            let attenuation = 1;
            if (light !== 'directional')
              attenuation = three.MathUtils.clamp((2.5 - position.distanceTo(p)) / (2.5 - 0.5), 0, 1);
            if (light === 'spot') {
              const cosine = way.clone().negate().dot(along);
              attenuation *= cosine < 0.85 ? 0 : cosine ** 6;
              if (Math.abs(cosine - 0.85) < 1e-4) continue;
            }
            const diffuse = Math.max(n.dot(way), 0);
            const reflected = n
              .clone()
              .multiplyScalar(2 * n.dot(way))
              .sub(way);
            const specular = diffuse > 0 ? Math.max(reflected.dot(view), 0) ** 12 : 0;
            for (let c = 0; c < 3; c++) {
              const lit =
                values.materialAmbient[c] * values.lightAmbient[c] +
                values.materialDiffuse[c] * values.lightDiffuse[c] * diffuse +
                values.materialSpecular[c] * values.lightSpecular[c] * specular;
              most = Math.max(most, Math.abs(data[(y * size + x) * 4 + c] - lit * attenuation * 1.5));
            }
          }
        }
        worst[`${light}, ${technique}`] = most;
      }
    }
    return worst;
  }, thesis);
  for (const [name, most] of Object.entries(worst)) expect(most, name).toBeLessThan(1e-4);
  expect(Object.keys(worst)).toHaveLength(6);
});

const builtins = ['waves', 'water', 'snow', 'moss', 'dissolve', 'rust', 'hologram', 'plain'] as const;
const builtinText = (name: string): string =>
  readFileSync(new URL(`../../apps/editor/src/model/surfaces/${name}.surface`, import.meta.url), 'utf8');

test('the surfaces that the editor begins with are drawn alike by every technique, in the bounds that they declare @verify', async ({
  benchPage: page,
}) => {
  const texts = Object.fromEntries(builtins.map((name) => [name, builtinText(name)]));
  const results = await page.evaluate((given) => {
    const { Bench, compareImages, drawn, isFlat, surfaces, three } = window.testPage;
    const bench = new Bench(160, 96);
    bench.webgl.shadowMap.enabled = true;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(45, 160 / 96, 0.1, 30);
    camera.position.set(0, 3, 7);
    camera.lookAt(0, 0.4, 0);
    const worn = Object.entries(given).map(([name, text], i) => {
      const surface = new surfaces.Surface(name, text);
      surface.time.value = 1.5;
      const material = new three.MeshStandardMaterial({ color: 0x887766, side: three.DoubleSide });
      const values = surfaces.setSurface(material, surface);
      const geometry =
        name === 'water'
          ? new three.PlaneGeometry(2, 2, 48, 48).rotateX(-Math.PI / 2)
          : new three.SphereGeometry(0.7, 48, 32);
      const mesh = new three.Mesh(geometry, material);
      mesh.position.set((i % 4) * 1.8 - 2.7, i < 4 ? 0.8 : 0.7, i < 4 ? -1.4 : 1.2);
      mesh.castShadow = mesh.receiveShadow = true;
      scene.add(mesh);
      return { name, mesh, material, values, displaces: surface.displaces };
    });
    const floor = new three.Mesh(
      new three.PlaneGeometry(12, 12).rotateX(-Math.PI / 2),
      new three.MeshStandardMaterial({ color: 0x777777 }),
    );
    floor.receiveShadow = true;
    const spot = new three.SpotLight(0xfff0e0, 120, 20, 0.8, 0.5);
    spot.position.set(2, 7, 4);
    spot.castShadow = true;
    spot.shadow.mapSize.set(256, 256);
    spot.shadow.bias = -0.003;
    const point = new three.PointLight(0x88aaff, 8, 8);
    point.position.set(-3, 2, 3);
    scene.add(floor, spot, spot.target, point, new three.AmbientLight(0x404040));
    const expected = bench.byTechnique('forward-single-pass', scene, camera);
    const plain = () => {
      for (const { material } of worn) surfaces.setSurface(material, null);
      return bench.byTechnique('forward-single-pass', scene, camera);
    };
    const pictures = drawn.map((technique) => {
      bench.byTechnique(technique, scene, camera);
      const picture = bench.byTechnique(technique, scene, camera);
      return { technique, flat: isFlat(picture), difference: compareImages(expected, picture) };
    });
    const reaches = worn.map(({ name, material, displaces }) => ({
      name,
      displaces,
      reach: surfaces.surfaceReach(material),
    }));
    return { pictures, reaches, changed: compareImages(expected, plain()).share };
  }, texts);
  for (const { technique, flat, difference } of results.pictures) {
    expect(flat).toBe(false);
    // what a hash of noise decides, a hole or none, may fall on its other side in a pixel: no bound of the largest difference
    checkAgreement(technique, difference, 'built-in surfaces', {
      largest: 1,
      share: technique === 'inferred' ? 0.12 : 0.001,
    });
  }
  expect(results.changed).toBeGreaterThan(0.1);
  expect(results.reaches.filter(({ displaces }) => displaces).map(({ name }) => name)).toEqual([
    'waves',
    'water',
    'snow',
  ]);
  for (const { name, displaces, reach } of results.reaches)
    expect(displaces ? reach > 0 && reach < 1 : reach === 0, `${name}: ${reach} m`).toBe(true);
});

test('what a surface moves throws the shadow of where it is, by every kind of light and of shadow map, and is culled by its declared reach', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, surfaces, three } = window.testPage;
    const bench = new Bench(96, 72);
    bench.webgl.shadowMap.enabled = true;
    const far = 30;
    const text = `uniform float way; // = 30\n// reach: way\nvoid displace(inout VertexData v) { v.positionOS.x += way; }`;
    const surface = new surfaces.Surface('moves', text);
    const lights = {
      spot: () => Object.assign(new three.SpotLight(0xffffff, 60, 14, 0.8, 0.5), { name: 'spot' }),
      directional: () => new three.DirectionalLight(0xffffff, 2),
      point: () => new three.PointLight(0xffffff, 60, 14),
    };
    const kinds = [three.PCFShadowMap, three.VSMShadowMap] as const;
    const draw = (light: keyof typeof lights, kind: (typeof kinds)[number], how: 'moved' | 'displaced' | 'culled') => {
      bench.webgl.shadowMap.type = kind;
      const scene = new three.Scene();
      const camera = new three.PerspectiveCamera(45, 96 / 72, 0.1, 40);
      camera.position.set(0, 2, 5);
      camera.lookAt(0, 0.3, 0);
      const material = new three.MeshStandardMaterial({ color: 0xff5500 });
      const mesh = new three.Mesh(new three.TorusGeometry(0.5, 0.2, 12, 24), material);
      mesh.position.set(how === 'moved' ? 0 : -far, 0.9, 0);
      // alone what receives shadows says how fine their maps are, by its bounds
      mesh.castShadow = true;
      if (how !== 'moved') surfaces.setSurface(material, surface);
      if (how === 'displaced') {
        mesh.geometry.computeBoundingSphere();
        const sphere = mesh.geometry.boundingSphere!.clone();
        sphere.radius += surfaces.surfaceReach(material);
        Object.assign(mesh, { boundingSphere: sphere });
      }
      const floor = new three.Mesh(
        new three.PlaneGeometry(8, 8).rotateX(-Math.PI / 2),
        new three.MeshStandardMaterial(),
      );
      floor.receiveShadow = true;
      const made = lights[light]();
      made.position.set(1, 5, 3);
      made.castShadow = true;
      scene.add(mesh, floor, made, new three.AmbientLight(0x404040));
      if ('target' in made) scene.add(made.target);
      bench.byTechnique('deferred', scene, camera);
      return bench.byTechnique('deferred', scene, camera);
    };
    return (Object.keys(lights) as (keyof typeof lights)[]).flatMap((light) =>
      kinds.map((kind) => {
        const moved = draw(light, kind, 'moved');
        return {
          name: `${light}, ${kind === three.VSMShadowMap ? 'variance' : 'PCF'}`,
          ...compareImages(moved, draw(light, kind, 'displaced')),
          culled: compareImages(moved, draw(light, kind, 'culled')).share,
        };
      }),
    );
  });
  expect(results).toHaveLength(6);
  for (const { name, psnr, share, culled } of results) {
    expect.soft(psnr, `${name}: ${psnr} dB`).toBeGreaterThan(50);
    expect.soft(share, name).toBeLessThan(0.002);
    // without a larger sphere nothing of it is drawn: the sphere is what is looked at
    expect.soft(culled, name).toBeGreaterThan(0.05);
  }
});
