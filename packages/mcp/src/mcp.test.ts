import { Client } from '@modelcontextprotocol/sdk/client/index.js';
import { InMemoryTransport } from '@modelcontextprotocol/sdk/inMemory.js';
import { describe, expect, it } from 'vitest';
import { agentPlaceFile } from '../../tools/reach/agentPlace.mjs';
import { EditorLink } from './EditorLink';
import { findEditor, placeFile } from './findEditor';
import { makeServer } from './makeServer';
import { checkInput, isReading, tools } from './tools';

/** An MCP client whose editor returns each call as its answer. */
async function connect(): Promise<Client> {
  const link = new EditorLink(() => ({ url: 'http://127.0.0.1:9/', key: '' }));
  link.call = async (tool, input) => ({
    content: [{ type: 'text', text: JSON.stringify({ tool, input, client: link.name }) }],
  });
  const client = new Client({ name: 'a-client', version: '1.0.0' });
  const [ours, theirs] = InMemoryTransport.createLinkedPair();
  await Promise.all([makeServer(link).connect(theirs), client.connect(ours)]);
  return client;
}

describe('the tools', () => {
  it('are few, and described in few words', async () => {
    const { tools: listed } = await (await connect()).listTools();
    expect(listed.length).toBeLessThanOrEqual(20);
    expect(JSON.stringify(listed).length).toBeLessThan(24_000);
    for (const { name, description, inputSchema, annotations } of listed) {
      expect(description!.length, name).toBeLessThan(200);
      expect(inputSchema, name).toMatchObject({ type: 'object', additionalProperties: false });
      expect(annotations?.readOnlyHint, name).toBe(isReading(name as keyof typeof tools));
    }
  });

  it('are passed to the editor with the name of the client, once their input is checked', async () => {
    const client = await connect();
    const call = async (name: string, input: Record<string, unknown>): Promise<string> => {
      const { content } = await client.callTool({ name, arguments: input });
      return (content as { text: string }[])[0].text;
    };
    const moved = { object: 'Lamp', position: [0, 1, 2] };
    expect(JSON.parse(await call('move_object', moved))).toEqual({
      tool: 'move_object',
      input: moved,
      client: 'a-client',
    });
    expect(await call('move_object', { object: 'Lamp', position: [0, 1] })).toMatch(/position/);
    expect(await call('move_object', { object: 'Lamp', at: [0, 1, 2] })).toMatch(/at/);
  });

  it('name what is wrong with an input', () => {
    expect(() => checkInput('move', {})).toThrow(/^There is no tool “move”: there are get_scene, /);
    expect(() => checkInput('__proto__', {})).toThrow(/There is no tool/);
    expect(() => checkInput('undo', { steps: 0 })).toThrow(/^undo cannot take this\. steps: /);
    const edits = Array.from({ length: 201 }, () => ({ edit: 'delete', objects: ['A'] }));
    expect(() => checkInput('batch', { edits })).toThrow(/200/);
    expect(() => checkInput('batch', { edits: [{ edit: 'undo' }] })).toThrow(/edits\.0/);
  });
});

describe('the dev server', () => {
  it('is found by what npm start notes, or by the environment, on this machine alone', () => {
    expect(placeFile()).toBe(agentPlaceFile());
    const env = (url: string): Record<string, string> => ({ FAROL_AGENT_URL: url, FAROL_AGENT_KEY: 'key' });
    expect(findEditor(env('http://127.0.0.1:5300/'))).toEqual({ url: 'http://127.0.0.1:5300/', key: 'key' });
    for (const url of ['http://192.168.1.5:5173/', 'http://localhost.example:80/', 'http://localhost@example.com/'])
      expect(() => findEditor(env(url)), url).toThrow('is not on this machine');
  });

  it('that does not answer is named, with what to do', async () => {
    const link = new EditorLink(() => ({ url: 'http://127.0.0.1:9/', key: 'key' }));
    await expect(link.call('get_scene', {})).rejects.toThrow(/^The editor cannot be reached .*npm start/);
  });
});
