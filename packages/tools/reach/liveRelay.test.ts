import { createHash } from 'node:crypto';
import { createServer, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import WebSocket from 'ws';
import { LiveRelay, liveLimits } from './liveRelay.mjs';
import { tokenIn } from './networkServer.mjs';

const KEY = 'a-secret-of-the-editors';
const AGENT_KEY = 'a-secret-of-the-agents';

/** A page's socket, with what it was told. */
class Page {
  readonly told: { kind: string; [key: string]: unknown }[] = [];
  readonly closed: Promise<number>;
  private readonly changes: (() => void)[] = [];

  constructor(readonly socket: WebSocket) {
    socket.on('message', (data) => {
      this.told.push(JSON.parse(String(data)));
      for (const change of this.changes.splice(0)) change();
    });
    socket.on('error', () => {});
    this.closed = new Promise((resolve) => socket.on('close', resolve));
  }

  /** Fulfilled with the first message of a kind after the first `from`. */
  async hears(kind: string, from = 0): Promise<Record<string, unknown>> {
    for (;;) {
      const found = this.told.slice(from).find((each) => each.kind === kind);
      if (found) return found;
      await new Promise<void>((resolve) => this.changes.push(resolve));
    }
  }

  say(message: object): void {
    this.socket.send(JSON.stringify(message));
  }
}

let relay: LiveRelay;
let server: Server;
let origin: string;
const problems: string[] = [];

beforeEach(async () => {
  problems.length = 0;
  relay = new LiveRelay(AGENT_KEY);
  relay.onProblem = (problem) => problems.push(problem);
  server = createServer((request, response) => relay.answer(request, response, () => response.writeHead(404).end()));
  server.on('upgrade', (request, socket, head) => relay.upgrade(request, socket, head));
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  origin = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
});

afterEach(async () => {
  relay.close();
  server.closeAllConnections();
  await new Promise((resolve) => server.close(resolve));
});

const open = (query: string, from = origin): Page =>
  new Page(new WebSocket(`${origin.replace('http', 'ws')}/farol-live?${query}`, { origin: from }));

/** Status of the answer to a socket that is refused. */
const refusal = ({ socket }: Page): Promise<number | undefined> =>
  new Promise((resolve) => {
    socket.on('unexpected-response', (_request, { statusCode }) => resolve(statusCode));
  });

async function edit(): Promise<{ editor: Page; id: string }> {
  const editor = open(`edit=${KEY}`);
  return { editor, id: (await editor.hears('hello')).id as string };
}

describe('the relay of live edits', () => {
  it('refuses a page of another origin, and a name that was led to this machine', async () => {
    expect(await refusal(open(`edit=${KEY}`, 'https://elsewhere.example'))).toBe(403);
    const port = new URL(origin).port;
    const headers = { host: `elsewhere.example:${port}`, origin: `http://elsewhere.example:${port}` };
    const led = new WebSocket(`ws://127.0.0.1:${port}/farol-live?edit=${KEY}`, { headers });
    expect(await refusal(new Page(led))).toBe(403);
    expect(await refusal(open('edit=short'))).toBe(400);
    expect(await refusal(open(''))).toBe(400);
  });

  it('announces who begins to look, counts them, and sends everything to the one who waits', async () => {
    const { editor, id } = await edit();
    const first = open(`look=${id}`);
    const { number } = await editor.hears('join');
    const beforeSecond = editor.told.length;
    const second = open(`look=${id}`);
    expect((await editor.hears('looks', beforeSecond)).looks).toBe(2);
    const other = await editor.hears('join', beforeSecond);
    expect(other.number).not.toBe(number);
    editor.say({ kind: 'whole', to: other.number });
    editor.say({ kind: 'parts', parts: [['o/1', '{}']] });
    expect((await second.hears('parts')).parts).toEqual([['o/1', '{}']]);
    await first.hears('parts');
    expect(second.told.map(({ kind }) => kind)).toEqual(['whole', 'parts']);
    expect(first.told.map(({ kind }) => kind)).toEqual(['parts']);
    const beforeLeaving = editor.told.length;
    second.socket.close();
    expect((await editor.hears('looks', beforeLeaving)).looks).toBe(1);
  });

  it('asks the editor for everything anew, tells that it is away, and announces all when it is back', async () => {
    const { editor, id } = await edit();
    const look = open(`look=${id}`);
    await editor.hears('join');
    const before = editor.told.length;
    look.say({ kind: 'again' });
    await editor.hears('join', before);
    editor.socket.close();
    await look.hears('away');
    const { editor: back, id: same } = await edit();
    expect(same).toBe(id);
    await back.hears('join');
    expect(back.told[0].looks).toBe(1);
  });

  it('names and drops what is no message of a side, and ends a page that sends too much', async () => {
    const { editor, id } = await edit();
    const look = open(`look=${id}`);
    await editor.hears('join');
    const before = editor.told.length;
    look.socket.send('{"kind":');
    expect((await look.hears('problem')).problem).toBe('The message is no JSON object.');
    look.say({ kind: 'parts', parts: [] });
    await look.hears('problem', look.told.length);
    expect(problems).toEqual([
      'A message that is no JSON object was dropped: "{\\"kind\\":"',
      expect.stringMatching(/^A message that is of no kind that this page may send was dropped: /),
    ]);
    look.socket.send('x'.repeat(liveLimits.look + 1));
    expect(await look.closed).toBe(1009);
    await editor.hears('looks', before);
    expect(editor.told.slice(before).map(({ kind }) => kind)).toEqual(['looks']);
  });

  it('keeps bytes that the editor sends by their hash, and nobody else', async () => {
    const { id } = await edit();
    const body = 'bytes of a model';
    const url = `${origin}/farol-live/${id}/${createHash('sha256').update(body).digest('hex')}`;
    const put = async (headers: Record<string, string>, text = body): Promise<number> =>
      (await fetch(url, { method: 'PUT', body: text, headers })).status;
    expect(await put({ origin, 'x-farol-key': 'another-key-of-someone' })).toBe(403);
    expect(await put({ origin: 'https://elsewhere.example', 'x-farol-key': KEY })).toBe(403);
    expect(await put({ origin, 'x-farol-key': KEY }, 'others')).toBe(400);
    expect((await fetch(url)).status).toBe(404);
    expect(await put({ origin, 'x-farol-key': KEY })).toBe(200);
    expect(await (await fetch(url)).text()).toBe(body);
  });
});

describe('the relay of agents', () => {
  const agentSocket = (headers: Record<string, string>): Page =>
    new Page(new WebSocket(`${origin.replace('http', 'ws')}/farol-live?agent`, { headers }));
  const agent = (): Page => agentSocket({ 'x-farol-agent': AGENT_KEY });

  it('lets in by the key alone, and nothing that a browser sends, of this page or of another', async () => {
    expect(await refusal(agentSocket({}))).toBe(403);
    expect(await refusal(agentSocket({ 'x-farol-agent': 'another-key' }))).toBe(403);
    expect(await refusal(agentSocket({ 'x-farol-agent': AGENT_KEY, origin }))).toBe(403);
    expect(await refusal(agentSocket({ 'x-farol-agent': AGENT_KEY, origin: 'null' }))).toBe(403);
    expect(await refusal(agentSocket({ 'x-farol-agent': AGENT_KEY, host: 'elsewhere.example' }))).toBe(403);
    expect(await refusal(open('allow', 'https://elsewhere.example'))).toBe(403);
    expect(await refusal(open(`agent=${AGENT_KEY}`))).toBe(403);
    relay.agentKey = undefined;
    expect(await refusal(agentSocket({ 'x-farol-agent': 'undefined' }))).toBe(403);
  });

  it('says that nobody allows it, then passes calls on with the number of the agent, and results back to it alone', async () => {
    const [first, second] = [agent(), agent()];
    await new Promise((resolve) => first.socket.on('open', resolve));
    first.say({ kind: 'call', id: 1, tool: 'get_scene', input: {} });
    await first.hears('away');
    const page = open('allow');
    await page.hears('hello');
    await first.hears('there');
    await second.hears('there');
    first.say({ kind: 'call', id: 2, tool: 'get_scene', input: {}, number: 77 });
    const { number, id } = await page.hears('call');
    expect(id).toBe(2);
    page.say({ kind: 'result', to: number, id, content: [] });
    await first.hears('result');
    expect(second.told.map(({ kind }) => kind)).toEqual(['there']);
    first.socket.close();
    expect((await page.hears('left')).number).toBe(number);
    page.socket.close();
    await second.hears('away');
  });

  it('gives the agents to the page that allowed them last, and ends what is too large or of no kind', async () => {
    const one = open('allow');
    await one.hears('hello');
    const two = open('allow');
    await two.hears('hello');
    expect(await one.closed).toBe(4000);
    const client = agent();
    await new Promise((resolve) => client.socket.on('open', resolve));
    client.say({ kind: 'whole' });
    await client.hears('problem');
    client.socket.send('x'.repeat(liveLimits.agent + 1));
    expect(await client.closed).toBe(1009);
    await two.hears('left');
    expect(two.told.map(({ kind }) => kind)).toEqual(['hello', 'left']);
  });
});

describe('the token of an address', () => {
  const has = (url: string, cookie?: string): unknown =>
    tokenIn({ url, headers: { cookie } } as Parameters<typeof tokenIn>[0], 'right');

  it('lets in by the address, then by the cookie, and by nothing else', () => {
    expect(has('/?token=right')).toBe('address');
    expect(has('/live.html?token=right&look=1')).toBe('address');
    expect(has('/src/main.tsx', 'other=1; farol-token=right')).toBe('cookie');
    expect(has('/')).toBeNull();
    expect(has('/?token=wrong', 'farol-token=')).toBeNull();
    expect(has('/?token=')).toBeNull();
    expect(has('//')).toBeNull();
  });
});
