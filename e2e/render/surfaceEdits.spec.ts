import { expect, test } from '../support/benchTest';

test.describe.configure({ timeout: 240_000 });

test('an edit that does not compile is refused with its line and leaves the picture; uniforms are each material’s own; programs are shared', async ({
  benchPage: page,
}) => {
  const result = await page.evaluate(() => {
    const { authoring, Bench, compareImages, surfaces, three } = window.testPage;
    const bench = new Bench(64, 48);
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(45, 64 / 48, 0.1, 20);
    camera.position.z = 4;
    scene.add(new three.AmbientLight(0xffffff, 3));
    const text = (body: string) =>
      `uniform float grey; // = 0.25 [0, 1]\nvoid surface(inout SurfaceData s) {\n  ${body}\n}\n`;
    const surface = new surfaces.Surface('grey', text('s.color = vec3(grey);'));
    const materials = [-0.8, 0.8].map((x) => {
      const material = new three.MeshLambertMaterial();
      scene.add(new three.Mesh(new three.PlaneGeometry(1.4, 1.4), material).translateX(x));
      return material;
    });
    const [left, right] = materials.map((material) => surfaces.setSurface(material, surface));
    const draw = () => bench.byTechnique('deferred', scene, camera);
    const at = (image: { data: Float32Array }, x: number) => image.data[(24 * 64 + x) * 4];
    const first = draw();
    const { programs } = bench;
    right.grey.value = 0.75;
    const second = draw();
    let problem: unknown = null;
    try {
      surface.source = text('s.color = vec3(gray);');
    } catch (error) {
      problem = error;
    }
    const kept = compareImages(second, draw()).largest;
    surface.source = `uniform float more; // = 0.5\n${text('s.color = vec3(grey * more);')}`;
    const edited = draw();
    const again = (left as Record<string, { value: unknown }>).more.value;
    surface.source = text('s.color = vec3(grey);');
    const back = compareImages(second, draw()).largest;
    const unknown = [() => surfaces.setSurface(materials[0], surface, { gray: 1 })];
    unknown.push(() => surfaces.setSurface(new three.ShaderMaterial({ name: 'own' }), surface));
    return {
      values: [at(first, 20), at(first, 44), at(second, 20), at(second, 44), at(edited, 20), at(edited, 44)],
      isRefused: problem instanceof authoring.MicroShaderCompileError,
      entries:
        problem instanceof authoring.MicroShaderCompileError ? problem.entries.map((entry) => ({ ...entry })) : [],
      kept,
      again,
      back,
      programs: [programs, bench.programs],
      messages: unknown.map((run) => window.testPage.messageOf(run)),
    };
  });
  const [a, b, c, d, e, f] = result.values;
  expect(b).toBe(a);
  expect(c).toBe(a);
  expect(d / a).toBeCloseTo(3, 1);
  expect(e / a).toBeCloseTo(0.5, 1);
  expect(f / a).toBeCloseTo(1.5, 1);
  expect(result.isRefused).toBe(true);
  expect(result.entries[0]).toMatchObject({ chunk: 'grey', line: 3, text: 's.color = vec3(gray);' });
  expect(result.entries[0].message).toContain("'gray'");
  expect(result).toMatchObject({ kept: 0, back: 0, again: 0.5 });
  expect(result.messages[0]).toContain('Surface "grey" has no uniform "gray"');
  expect(result.messages[1]).toContain('Material "own" cannot have a surface');
});

test('after a lost context all is drawn again as before it; one surface that does not compile leaves the others as they are', async ({
  benchPage: page,
  watch,
}) => {
  const result = await page.evaluate(async () => {
    const { Bench, compareImages, surfaces, three } = window.testPage;
    const bench = new Bench(64, 48, { losesContext: true });
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(45, 64 / 48, 0.1, 20);
    camera.position.z = 4;
    scene.add(new three.AmbientLight(0xffffff, 3));
    const below = new three.MeshStandardMaterial({ color: 0x8888ff });
    const tint = new surfaces.Surface('tint', 'void surface(inout SurfaceData s) { s.color *= vec3(1.0, 0.5, 0.25); }');
    const lift = new surfaces.Surface('lift', 'void displace(inout VertexData v) { v.positionOS.y += 0.3; }');
    surfaces.setSurface(below, tint);
    // as the engine has one object of a material wear one more
    const layered = Object.create(below) as typeof below;
    Object.defineProperty(layered, 'id', { value: new three.Material().id });
    Object.defineProperty(layered, 'version', { get: () => below.version, set() {} });
    Object.assign(layered, { _listeners: undefined });
    surfaces.layerSurface(layered, below, lift);
    for (const [x, material] of [
      [-0.8, below],
      [0.8, layered],
    ] as const)
      scene.add(new three.Mesh(new three.PlaneGeometry(1.4, 1.4), material).translateX(x));
    const draw = () => bench.byTechnique('deferred', scene, camera);
    const first = draw();
    const both = [surfaces.getSurfaces(below), surfaces.getSurfaces(layered)].map((list) => list.length);
    await bench.loseContext();
    const again = draw();
    const broken = new surfaces.Surface('broken', 'void surface(inout SurfaceData s) { s.color = vec3(gone); }');
    surfaces.addSurface(layered, broken);
    const without = draw();
    return {
      both,
      again: compareImages(first, again).largest,
      without: compareImages(again, without).largest,
      shows: first.data[(24 * 64 + 20) * 4] / first.data[(24 * 64 + 20) * 4 + 1],
      lifted: first.data[(36 * 64 + 44) * 4] - first.data[(12 * 64 + 44) * 4],
    };
  });
  expect(result.both).toEqual([1, 2]);
  expect(result).toMatchObject({ again: 0, without: 0 });
  expect(result.shows).toBeGreaterThan(1.5);
  expect(Math.abs(result.lifted)).toBeGreaterThan(0.05);
  expect(watch.forgive(/Context Lost|Context Restored|context was lost/i)).toBeGreaterThan(0);
  expect(watch.forgive(/Farol: an object is drawn without its surface: Surface "broken" does not compile/)).toBe(1);
});

test('a text that moves vertices is edited while it is drawn; what does not compile leaves the picture', async ({
  benchPage: page,
}) => {
  const result = await page.evaluate(() => {
    const { authoring, Bench, compareImages, surfaces, three } = window.testPage;
    const bench = new Bench(64, 48);
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(45, 64 / 48, 0.1, 20);
    camera.position.z = 4;
    const mesh = new three.Mesh(new three.PlaneGeometry(1, 1), new three.MeshStandardMaterial());
    scene.add(mesh, new three.AmbientLight(0xffffff, 3));
    const draw = () => bench.byTechnique('deferred', scene, camera);
    const text = (x: string) => `void displace(inout VertexData v) { v.positionOS.x += ${x}; }`;
    mesh.position.x = 0.75;
    const moved = draw();
    mesh.position.x = 0;
    const surface = new surfaces.Surface('moves', text('-0.5'));
    surfaces.setSurface(mesh.material, surface);
    draw();
    surface.source = text('0.75');
    const edited = draw();
    let problem: unknown = null;
    try {
      surface.source = text('gone');
    } catch (error) {
      problem = error;
    }
    return {
      edited: compareImages(moved, edited).share,
      kept: compareImages(edited, draw()).largest,
      line: problem instanceof authoring.MicroShaderCompileError ? problem.entries[0].line : null,
    };
  });
  expect(result).toEqual({ edited: 0, kept: 0, line: 1 });
});
