import { join } from 'node:path';
import { root } from '@farol/tools/root';
import { serveApps } from '@farol/tools/serveApps';
import { Client } from '@modelcontextprotocol/sdk/client/index.js';
import { StdioClientTransport } from '@modelcontextprotocol/sdk/client/stdio.js';
import type { Page } from '@playwright/test';
import { axeProblems } from '../support/axeProblems';
import { expect, test } from '../support/test';
import { history, serialized } from './editor';

let served: Awaited<ReturnType<typeof serveApps>>;

test.beforeAll(async () => {
  const built = process.env.FAROL_E2E === 'built';
  served = await serveApps({ ports: { editor: 0 }, built, watch: false });
});

test.afterAll(() => served.close());

interface Part {
  readonly type: string;
  readonly text?: string;
  readonly data?: string;
}

/** An MCP client that starts the server as users do, and counts its calls. */
class Agent {
  readonly client = new Client({ name: 'test-client', title: 'Test client', version: '1.0.0' });
  calls = 0;

  connect(): Promise<void> {
    const env = { ...process.env, FAROL_AGENT_URL: served.urls.editor!, FAROL_AGENT_KEY: served.agentKey };
    const args = [join(root, 'packages/tools/mcp.mjs')];
    return this.client.connect(
      new StdioClientTransport({ command: process.execPath, args, env: env as Record<string, string> }),
    );
  }

  async parts(name: string, input: object = {}): Promise<readonly Part[]> {
    this.calls++;
    const { content, isError } = await this.client.callTool({ name, arguments: { ...input } });
    const parts = content as readonly Part[];
    if (isError) throw new Error(`${name}: ${parts[0].text}`);
    return parts;
  }

  /** Answer of a tool, from JSON. */
  async call(name: string, input: object = {}): Promise<Record<string, unknown>> {
    const [{ text = '' }] = await this.parts(name, input);
    return JSON.parse(text) as Record<string, unknown>;
  }
}

async function openEditor(page: Page): Promise<void> {
  await page.goto(`${served.urls.editor}?scene=empty`);
  await page.waitForFunction(() => 'editor' in window);
  await page.evaluate(() => window.editor.ready);
}

async function allow(page: Page): Promise<void> {
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Let an agent edit…' }).click();
  await page.getByRole('button', { name: 'Allow it' }).click();
  await expect(page.getByRole('dialog')).toBeHidden();
}

/** Mean of the encoded channels of a picture's lower half, from 0 to 255. */
const brightness = (page: Page, [picture]: readonly Part[]): Promise<number> =>
  page.evaluate(async (data) => {
    const bytes = Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/jpeg' }));
    const copy = Object.assign(document.createElement('canvas'), { width: 64, height: 64 });
    const context = copy.getContext('2d')!;
    context.drawImage(bitmap, 0, 0, 64, 64);
    const values = context.getImageData(0, 32, 64, 32).data;
    let sum = 0;
    for (let i = 0; i < values.length; i += 4) sum += values[i] + values[i + 1] + values[i + 2];
    return sum / (values.length / 4) / 3;
  }, picture.data!);

test('an agent edits once it is allowed, each call is a step, and the bar tells of it until it is ended', async ({
  page,
}) => {
  await openEditor(page);
  const agent = new Agent();
  await agent.connect();
  await expect(agent.call('get_scene')).rejects.toThrow('File > Let an agent edit…');
  await allow(page);
  const bar = page.getByRole('complementary', { name: 'An agent may edit' });
  await expect(bar).toContainText('Test client may edit');

  const lamp = { name: 'Lamp', what: 'Point light', position: [0, 2, 0], components: { Light: { intensity: 40 } } };
  const { objects } = (await agent.call('add_object', lamp)) as { objects: { path: string }[] };
  expect(objects.map(({ path }) => path)).toEqual(['Lamp']);
  const before = await serialized(page);
  await agent.call('batch', {
    label: 'Ground',
    edits: [
      { edit: 'add_object', what: 'plane', name: 'Ground' },
      { edit: 'move_object', object: 'Ground', by: [0, -0.1, 0] },
      { edit: 'set_fields', object: 'Lamp', component: 'Light', values: { diffuse: '#ffcc88' } },
    ],
  });
  expect(await history(page)).toEqual(['Test client added Lamp', 'Test client: Ground']);
  await expect(
    agent.call('set_fields', { object: 'Lamp', component: 'Light', values: { penumbra: 3 } }),
  ).rejects.toThrow('Light.penumbra must be a finite number from 0 to 1, not 3.');
  await agent.call('undo');
  expect(await serialized(page)).toBe(before);
  await expect(bar).toContainText('4 calls');

  await bar.getByRole('button', { name: 'End it' }).click();
  await expect(bar).toBeHidden();
  await expect(agent.call('get_scene')).rejects.toThrow('File > Let an agent edit…');
  await agent.client.close();
});

/** Calls that build a night street from the empty scene. */
const street: readonly (readonly [tool: string, input: object])[] = [
  ['open_scene', { name: 'empty' }],
  ['get_scene', {}],
  ['describe_type', {}],
  ['describe_type', { type: 'Light' }],
  ['set_fields', { object: 'scene', values: { background: 'colour', backgroundColour: '#04060c' } }],
  ['set_fields', { object: 'Sun', component: 'Light', values: { intensity: 0.02, diffuse: '#8fa8ff' } }],
  ['set_fields', { object: 'Sky', component: 'Light', values: { intensity: 0.01 } }],
  [
    'add_object',
    { what: 'plane', name: 'Road', scale: [8, 1, 40], components: { ObjectRenderer: { colour: '#3a3a3e' } } },
  ],
  [
    'batch',
    {
      label: 'Houses',
      edits: [
        { edit: 'add_object', what: 'box', name: 'House', position: [-8, 3, -12], scale: [6, 6, 5] },
        { edit: 'duplicate_along', objects: ['House'], kind: 'line', count: 5, offset: [0, 0, -7] },
        { edit: 'add_object', what: 'box', name: 'Shop', position: [8, 2, -12], scale: [6, 4, 5] },
        { edit: 'duplicate_along', objects: ['Shop'], kind: 'line', count: 5, offset: [0, 0, -7] },
      ],
    },
  ],
  [
    'batch',
    {
      label: 'A lamp',
      edits: [
        { edit: 'add_object', what: 'empty', name: 'Lamp', position: [-4.2, 0, -2] },
        {
          edit: 'add_object',
          what: 'cylinder',
          name: 'Post',
          parent: 'Lamp',
          position: [0, 2, 0],
          scale: [0.12, 4, 0.12],
        },
        {
          edit: 'add_object',
          ...{ what: 'Point light', name: 'Bulb', parent: 'Lamp/Post', position: [0, 0.55, 0] },
          components: { Light: { intensity: 60, range: 12, diffuse: '#ffc477' } },
        },
      ],
    },
  ],
  ['duplicate_along', { objects: ['Lamp'], kind: 'line', count: 6, offset: [0, 0, -6] }],
  [
    'duplicate_along',
    {
      objects: ['Lamp', 'Lamp 2', 'Lamp 3', 'Lamp 4', 'Lamp 5', 'Lamp 6'],
      kind: 'line',
      count: 2,
      offset: [8.4, 0, 0],
    },
  ],
  ['move_object', { object: 'Camera', position: [0, 2.2, 6], lookAt: [0, 1.2, -12] }],
  ['run_action', { id: 'edit.group', objects: ['House', 'Shop'] }],
];

test('an agent builds a night street with 12 lamps from the empty scene in 25 calls, which undo takes back one by one @verify', async ({
  page,
}) => {
  test.slow();
  await openEditor(page);
  await allow(page);
  const agent = new Agent();
  await agent.connect();
  const dark = { from: [0, 2.2, 6], to: [0, 1.2, -12], width: 320 };
  const states: string[] = [];
  let isLit = 0;
  for (const [tool, input] of street) {
    if (tool === 'duplicate_along' && isLit === 0)
      isLit = await brightness(page, await agent.parts('screenshot', dark));
    const steps = (await history(page)).length;
    const state = await serialized(page);
    await agent.call(tool, input);
    const more = (await history(page)).length - steps;
    expect(more, tool).toBe(/^(open|get|describe)/.test(tool) ? 0 : 1);
    if (more === 1) states.push(state);
  }
  const { lights } = (await agent.call('get_lights')) as { lights: { type: string; on: boolean; range: string }[] };
  const bulbs = lights.filter(({ type }) => type === 'point');
  expect(bulbs).toHaveLength(12);
  for (const bulb of bulbs) expect(bulb).toMatchObject({ on: true, range: '12 m' });
  const picture = await agent.parts('screenshot', { camera: 'Camera', width: 640 });
  expect(await brightness(page, picture), 'the lamps light the street').toBeGreaterThan(2 * isLit);
  const { messages } = (await agent.call('get_messages', { least: 'warning' })) as { messages: unknown[] };
  expect(messages).toEqual([]);
  expect(agent.calls).toBeLessThanOrEqual(25);

  for (const state of states.toReversed()) {
    await agent.call('undo');
    expect(await serialized(page)).toBe(state);
  }
  await expect(agent.call('undo')).rejects.toThrow('There is nothing to undo.');
  await agent.client.close();
});

test('each command that an agent runs is one step of the history, or none @verify', async ({ page }) => {
  test.slow();
  await openEditor(page);
  await allow(page);
  const agent = new Agent();
  await agent.connect();
  await agent.call('batch', {
    edits: [
      { edit: 'add_object', what: 'box', name: 'House' },
      { edit: 'add_object', what: 'box', name: 'Shop', position: [2, 0, 0] },
      { edit: 'add_object', what: 'Point light', name: 'Lamp', position: [0, 2, 0] },
    ],
  });
  const [{ text = '[]' }] = await agent.parts('list_actions');
  const actions = (JSON.parse(text) as { id: string }[]).filter(
    // other scenes, files, and pages of help; undo itself
    ({ id }) => !/^(file|help|play)\.|^edit\.(undo|redo)$/.test(id),
  );
  expect(actions.length).toBeGreaterThan(60);
  let edits = 0;
  for (const { id } of actions) {
    for (const objects of [['House', 'Shop'], ['Lamp']]) {
      const before = (await history(page)).length;
      const state = await serialized(page);
      const answer = await agent.call('run_action', { id, objects }).catch((error: Error) => error);
      if (answer instanceof Error) {
        expect(answer.message, id).toMatch(/is not available now|cannot be run/);
        continue;
      }
      if ('note' in answer) await page.keyboard.press('Escape');
      const steps = (await history(page)).length - before;
      expect(steps, `steps of ${id}`).toBeLessThanOrEqual(1);
      expect(answer.step === null, `${id} tells its step`).toBe(steps === 0);
      if (steps === 0) continue;
      edits++;
      await agent.call('undo');
      expect(await serialized(page), `undo of ${id}`).toBe(state);
    }
  }
  expect(edits).toBeGreaterThan(20);
  await agent.client.close();
});

test('the dialog and the bar that allow an agent are clean to axe in both themes, also at 390 pixels @verify', async ({
  page,
}) => {
  await openEditor(page);
  const ask = async (): Promise<void> => {
    for (const theme of ['light', 'dark'] as const) {
      await page.evaluate((chosen) => window.editor.preferences.setState({ theme: chosen }), theme);
      await page.locator(`html[data-theme="${theme}"]`).waitFor();
      expect(await axeProblems(page), theme).toEqual([]);
    }
  };
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Let an agent edit…' }).click();
  await expect(page.getByLabel('Setting of the MCP client')).toContainText('"command": "node"');
  await ask();
  await page.getByRole('button', { name: 'Allow it' }).click();
  const bar = page.getByRole('complementary', { name: 'An agent may edit' });
  await expect(bar).toContainText('none is connected yet');
  await expect(page.getByRole('dialog')).toBeHidden();
  await ask();
  await page.setViewportSize({ width: 390, height: 844 });
  await expect(bar.getByRole('button', { name: 'End it' })).toBeInViewport({ ratio: 1 });
  await ask();
});

test('what a page of another origin sends reaches neither the agents nor the editor @verify', async ({
  page,
  browser,
  pagesURL,
}) => {
  await openEditor(page);
  await allow(page);
  const context = await browser.newContext();
  const stranger = await context.newPage();
  await stranger.goto(pagesURL);
  const opens = await stranger.evaluate(
    ([address, key]) =>
      Promise.all(
        ['allow', 'agent', `agent=${key}`, `agent&x-farol-agent=${key}`].map(
          (query) =>
            new Promise((resolve) => {
              const socket = new WebSocket(`${address.replace('http', 'ws')}farol-live?${query}`);
              socket.addEventListener('open', () => resolve(true));
              socket.addEventListener('close', () => resolve(false));
            }),
        ),
      ),
    [served.urls.editor!, served.agentKey],
  );
  expect(opens).toEqual([false, false, false, false]);
  await context.close();
  // the page still has the agents
  const agent = new Agent();
  await agent.connect();
  expect(await agent.call('get_scene')).toMatchObject({ size: 3 });
  await agent.client.close();
});
