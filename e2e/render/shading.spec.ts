import { expect, test } from '../support/benchTest';

/** Sums of lights at the vertices, interpolated: rounding. */
const LARGEST = 1e-3;

test('flat and Gouraud shading by every technique: as three has flatShading, and as lights at the vertices give it', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, compareImages, drawn, farol, techniquesInTurn, three } = window.testPage;
    const { setShading } = farol;
    const bench = new Bench(96, 48);
    const camera = new three.PerspectiveCamera(40, 2, 0.1, 20);
    camera.position.z = 5;
    camera.updateMatrixWorld();
    const ball = new three.SphereGeometry(0.9, 12, 8);
    const phong = new three.MeshPhongMaterial({
      color: 0xc06040,
      specular: 0x808080,
      shininess: 12,
      side: three.DoubleSide,
    });
    const lambert = new three.MeshLambertMaterial({ color: 0x4080c0, emissive: 0x100804 });
    const lamps = [
      new three.PointLight(0xffe0c0, 9, 7),
      new three.PointLight(0x80a0ff, 6, 0),
      new three.DirectionalLight(0xffffff, 0.7),
    ];
    lamps[0].position.set(1.6, 1.4, 1.8);
    lamps[1].position.set(-2, -1, 2);
    lamps[2].position.set(-1, 2, 1);
    const open = new three.SphereGeometry(0.9, 12, 8, 0.3, 3);
    const sceneOf = (left: InstanceType<typeof three.Material>, right: InstanceType<typeof three.Material>) => {
      const scene = new three.Scene();
      const meshes = [new three.Mesh(open, left), new three.Mesh(ball, right)];
      meshes[0].position.x = -1;
      meshes[0].rotation.y = 2.4;
      meshes[1].position.x = 1;
      scene.add(...meshes, ...lamps.map((lamp) => lamp.clone()));
      return scene;
    };
    const scene = sceneOf(phong, lambert);
    // three's flatShading
    phong.flatShading = lambert.flatShading = true;
    phong.needsUpdate = lambert.needsUpdate = true;
    const flat = bench.stock(scene, camera);
    phong.flatShading = lambert.flatShading = false;
    phong.needsUpdate = lambert.needsUpdate = true;
    const smooth = bench.stock(scene, camera);

    // the same by a shader that lights vertices, by three's formulas
    const oracle = (
      color: InstanceType<typeof three.Color>,
      specular: number,
      shininess: number,
      emissive: number,
      side: 0 | 2,
    ) =>
      new three.ShaderMaterial({
        side,
        uniforms: {
          albedo: { value: color },
          glow: { value: new three.Color(emissive) },
          gloss: { value: new three.Color(specular) },
          shininess: { value: shininess },
          places: { value: lamps.map((lamp) => lamp.position.clone().applyMatrix4(camera.matrixWorldInverse)) },
          sun: { value: lamps[2].position.clone().transformDirection(camera.matrixWorldInverse) },
          colours: { value: lamps.map((lamp) => lamp.color.clone().multiplyScalar(lamp.intensity)) },
        },
        vertexShader: `
          uniform vec3 albedo, glow, gloss, sun, places[3], colours[3];
          uniform float shininess;
          varying vec3 front, back;
          vec3 lit(vec3 position, vec3 n) {
            vec3 v = normalize(-position);
            vec3 sum = glow;
            for (int i = 0; i < 3; i++) {
              vec3 away = places[i] - position;
              float d = length(away);
              vec3 l = i == 2 ? sun : away / d;
              float fade = i == 2 ? 1.0 : 1.0 / max(d * d, 0.01);
              if (i == 0) { float r = d / 7.0; fade *= pow(clamp(1.0 - r * r * r * r, 0.0, 1.0), 2.0); }
              vec3 h = normalize(l + v);
              float fresnel = exp2((-5.55473 * clamp(dot(v, h), 0.0, 1.0) - 6.98316) * clamp(dot(v, h), 0.0, 1.0));
              vec3 f = gloss * (1.0 - fresnel) + fresnel;
              float lobe = 0.25 * (0.5 * shininess + 1.0) / 3.14159265 * pow(clamp(dot(n, h), 0.0, 1.0), shininess);
              vec3 reflected = albedo / 3.14159265 + (shininess > 0.0 ? f * lobe : vec3(0.0));
              sum += max(dot(n, l), 0.0) * fade * colours[i] * reflected;
            }
            return sum;
          }
          void main() {
            vec4 place = modelViewMatrix * vec4(position, 1.0);
            vec3 n = normalize(normalMatrix * normal);
            front = lit(place.xyz, n);
            back = lit(place.xyz, -n);
            gl_Position = projectionMatrix * place;
          }`,
        fragmentShader: `
          varying vec3 front, back;
          void main() { gl_FragColor = vec4(gl_FrontFacing ? front : back, 1.0); }`,
      });
    const reference = sceneOf(oracle(phong.color, 0x808080, 12, 0, 2), oracle(lambert.color, 0, 0, 0x100804, 0));
    const gouraud = bench.stock(reference, camera);

    const names = techniquesInTurn(1, drawn);
    const versions = [phong.version, lambert.version];
    const results = names.map((technique) => {
      const by = (shading: Parameters<typeof setShading>[1]) => {
        setShading(phong, shading);
        setShading(lambert, shading);
        return bench.byTechnique(technique, scene, camera);
      };
      return {
        technique,
        flat: compareImages(flat, by('flat')),
        gouraud: compareImages(gouraud, by('gouraud')),
      };
    });
    setShading(phong, null);
    // dense meshes are shaded alike by either, physical materials too; a light more compiles nothing
    const dense = new three.Scene();
    const standard = new three.MeshStandardMaterial({ color: 0xb0a090, roughness: 0.6, metalness: 0.3 });
    dense.add(new three.Mesh(new three.SphereGeometry(1.2, 160, 80), standard), ...lamps);
    const pixels = bench.byTechnique('clustered-deferred', dense, camera);
    setShading(standard, 'gouraud');
    const vertices = compareImages(pixels, bench.byTechnique('clustered-deferred', dense, camera));
    const { programs } = bench;
    dense.add(...lamps.map((lamp) => lamp.clone()), ...lamps.map((lamp) => lamp.clone()));
    bench.byTechnique('clustered-deferred', dense, camera);
    return {
      results,
      apart: [compareImages(flat, smooth).largest, compareImages(gouraud, smooth).largest],
      touched: [phong.flatShading, phong.version - versions[0], JSON.stringify(phong.userData)],
      vertices,
      programs: bench.programs - programs,
    };
  });
  for (const largest of seen.apart) expect(largest, 'the three are to be told apart').toBeGreaterThan(0.02);
  const forward = new Set(['forward', 'forward-single-pass', 'tiled-forward', 'forward-plus', 'clustered-forward']);
  for (const { technique, flat, gouraud } of seen.results) {
    expect.soft(gouraud.largest, `${technique}, Gouraud`).toBeLessThan(LARGEST);
    if (forward.has(technique)) {
      expect.soft(flat.largest, `${technique}, flat`).toBeLessThan(1e-4);
    } else {
      const least = technique === 'inferred' ? 28 : 55;
      expect.soft(flat.psnr, `${technique}, flat`).toBeGreaterThan(least);
    }
  }
  expect(seen.touched).toEqual([false, 0, '{}']);
  expect(seen.vertices.psnr).toBeGreaterThan(45);
  expect(seen.programs).toBe(0);
});

test('lights of a LightField light what is Gouraud-shaded as single lights do, by every technique', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, compareImages, farol, lightFields, techniquesInTurn, three } = window.testPage;
    const { setShading } = farol;
    const bench = new Bench(96, 48);
    const camera = new three.PerspectiveCamera(40, 2, 0.1, 20);
    camera.position.z = 5;
    const scene = new three.Scene();
    const standard = new three.MeshStandardMaterial({ color: 0xb0a090, roughness: 0.5 });
    const phong = new three.MeshPhongMaterial({ color: 0xc06040, shininess: 12, side: three.DoubleSide });
    const lambert = new three.MeshLambertMaterial({ color: 0x4080c0 });
    // shaded in pixels beside them, and a transparent thing, which is always drawn forward
    const plain = new three.MeshStandardMaterial({ color: 0x808080 });
    const glass = new three.MeshPhongMaterial({ color: 0x80ff80, transparent: true, opacity: 0.5 });
    const ball = new three.SphereGeometry(0.55, 12, 8);
    [standard, phong, lambert, glass].forEach((material, i) => {
      const mesh = new three.Mesh(ball, material);
      mesh.position.set(-1.9 + i * 1.25, 0, i === 3 ? 0.6 : 0);
      scene.add(mesh);
      setShading(material, 'gouraud');
    });
    const wall = new three.Mesh(new three.PlaneGeometry(6, 3), plain);
    wall.position.z = -1;
    scene.add(wall, new three.DirectionalLight(0xffffff, 0.2));
    const lone = new three.PointLight(0xffe0c0, 2, 7);
    lone.position.set(0.5, 1.4, 1.8);
    scene.add(lone);
    const field = new lightFields.LightField(200, { spots: true });
    const lights: InstanceType<typeof three.Light>[] = [];
    for (let i = 0; i < 200; i++) {
      const [x, y, z] = [((i * 37) % 100) / 22 - 2.2, ((i * 61) % 100) / 40 - 1.2, ((i * 83) % 100) / 60];
      const [r, g, b] = [(i % 3) / 12, ((i + 1) % 4) / 12, ((i + 2) % 5) / 12];
      const range = 0.8 + (i % 7) / 10;
      field.setPoint(i, x, y, z, range, r, g, b);
      const isSpot = i % 3 === 0;
      if (isSpot) field.setCone(i, 0.2, -0.3, -1, 0.8, 0.4);
      const light = isSpot
        ? new three.SpotLight(0xffffff, 1, range, 0.8, 0.4, 2)
        : new three.PointLight(0xffffff, 1, range, 2);
      light.color.setRGB(r, g, b);
      light.position.set(x, y, z);
      if ('target' in light) {
        light.target.position.set(x + 0.2, y - 0.3, z - 1);
        scene.add(light.target);
      }
      lights.push(light);
    }
    const names = techniquesInTurn(3);
    return names.map((technique) => {
      const dark = bench.byTechnique(technique, scene, camera);
      scene.add(...lights);
      const alone = bench.byTechnique(technique, scene, camera);
      scene.remove(...lights);
      scene.add(field);
      const picture = bench.byTechnique(technique, scene, camera);
      scene.remove(field);
      return { technique, ...compareImages(alone, picture), lit: compareImages(alone, dark).largest };
    });
  });
  for (const { technique, largest, lit } of seen) {
    expect.soft(lit, `${technique}: the lights are to be seen`).toBeGreaterThan(0.1);
    // sums of half floats of several hundred lights, in another order
    expect.soft(largest, technique).toBeLessThan(5e-3);
  }
});

test('area lights light what is flat as faces of their own, and what is Gouraud-shaded at its vertices @verify', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { Bench, compareImages, drawn, farol, setLightOptions, techniquesInTurn, three } = window.testPage;
    const { setShading } = farol;
    const bench = new Bench(96, 48);
    const camera = new three.PerspectiveCamera(40, 2, 0.1, 20);
    camera.position.z = 5;
    const scene = new three.Scene();
    const standard = new three.MeshStandardMaterial({ color: 0xb0a090, roughness: 0.7 });
    // three's area lights light standard materials alone
    const lambert = new three.MeshLambertMaterial({ color: 0x4080c0 });
    const coarse = new three.SphereGeometry(0.9, 12, 8);
    const dense = new three.SphereGeometry(0.9, 96, 64);
    const left = new three.Mesh(coarse, standard);
    left.position.x = -1;
    const right = new three.Mesh(coarse, lambert);
    right.position.x = 1;
    const lamp = new three.PointLight(0xffe0c0, 3, 7);
    lamp.position.set(0.3, 1.6, 2);
    const shapes = ['rectangle', 'disc', 'tube'] as const;
    shapes.forEach((shape, i) => {
      const light = new three.RectAreaLight(0xffffff, 4, 1.2, 0.5);
      setLightOptions(light, { shape, range: 8 });
      light.position.set(-2.5 + 2 * i, 1.2 - i, 2);
      light.lookAt(-1, 0, 0);
      scene.add(light);
    });
    scene.add(left, right, lamp);
    // a mesh of faces of their own, as an oracle for flat
    const faces = new three.Mesh(coarse.toNonIndexed(), standard);
    faces.geometry.computeVertexNormals();
    faces.position.copy(left.position);
    const names = techniquesInTurn(0, drawn);
    return names.map((technique) => {
      const draw = () => bench.byTechnique(technique, scene, camera);
      const by = (shading: Parameters<typeof setShading>[1], draws = draw) => {
        setShading(standard, shading);
        setShading(lambert, shading);
        return draws();
      };
      scene.remove(right, left).add(faces);
      const own = by(null);
      scene.remove(faces).add(left);
      const flat = compareImages(own, by('flat'));
      scene.add(right);
      left.geometry = right.geometry = dense;
      const pixels = by(null);
      const vertices = compareImages(pixels, by('gouraud'));
      scene.traverse((object) => void ('isRectAreaLight' in object && (object.visible = false)));
      const dark = compareImages(pixels, by(null)).largest;
      scene.traverse((object) => void (object.visible = true));
      left.geometry = right.geometry = coarse;
      return { technique, flat: flat.psnr, vertices: vertices.psnr, dark };
    });
  });
  for (const { technique, flat, vertices, dark } of seen) {
    expect.soft(dark, `${technique}: the area lights are to be seen`).toBeGreaterThan(0.1);
    const isInferred = technique === 'inferred';
    expect.soft(flat, `${technique}, flat`).toBeGreaterThan(isInferred ? 28 : 55);
    expect.soft(vertices, `${technique}, Gouraud`).toBeGreaterThan(isInferred ? 28 : 45);
  }
});

test('light that grazes an iridescent surface is whole in the light buffer', async ({ benchPage: page }) => {
  const found = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(64, 48);
    const scene = new three.Scene();
    const material = new three.MeshPhysicalMaterial({ color: 0x222222, roughness: 0.4 });
    Object.assign(material, { iridescence: 1, iridescenceIOR: 1.3 });
    const floor = new three.Mesh(new three.PlaneGeometry(12, 30), material);
    floor.rotation.x = -Math.PI / 2;
    // low before the camera: seen by its mirror image, where Fresnel's weight is large
    const sun = new three.DirectionalLight(0xffffff, 1);
    sun.position.set(0, 0.12, -1);
    scene.add(floor, sun);
    const camera = new three.PerspectiveCamera(30, 64 / 48, 0.1, 60);
    camera.position.set(0, 1.5, 12);
    camera.lookAt(0, 0, 0);
    const stock = bench.stock(scene, camera);
    const plain = compareImages(stock, bench.byTechnique('light-prepass', scene, camera));
    return { ...plain, brightest: Math.max(...stock.data.filter((_, i) => i % 4 === 0)) };
  });
  expect(found.brightest, 'the glare is seen').toBeGreaterThan(0.3);
  expect(found.psnr).toBeGreaterThan(55);
});
