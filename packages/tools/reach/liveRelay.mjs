import { createHash, timingSafeEqual } from 'node:crypto';
import { WebSocketServer } from 'ws';
import { livePath } from './livePath.mjs';

/** Limits of what a page or an agent may send (bytes), of agents, and of pages that look at one scene (`looks`). */
export const liveLimits = {
  ...{ edit: 64e6, look: 1000, agent: 1e6, asset: 256e6, assets: 1e9, unsent: 128e6 },
  ...{ looks: 32, agents: 8 },
};

/** Time between two questions to each page whether it is still there (ms). */
const PING = 10_000;

/** Kinds of messages that each side may send. */
const kinds = { edit: ['whole', 'parts', 'end', 'play'], look: ['again'], allow: ['result'], agent: ['name', 'call'] };

/**
 * Edited scene that pages look at.
 *
 * @typedef {object} Session
 * @property {import('ws').WebSocket | null} editor - null while its page is away
 * @property {Map<number, import('ws').WebSocket>} looks - pages that look, by number
 * @property {Map<string, Buffer>} assets - bytes by their SHA-256 (hex)
 */

/** Compares a text with the secret in constant time. @param {string | null | undefined} text @param {string} secret */
export function isSecret(text, secret) {
  const digest = (/** @type {string} */ each) => createHash('sha256').update(each).digest();
  return typeof text === 'string' && timingSafeEqual(digest(text), digest(secret));
}

/**
 * Passes edits of a scene from an editor's page on to pages that look at it, and tells the editor how many look. It keeps
 * no scene: a page that begins to look is announced to the editor, which sends it everything. An editor opens the socket
 * with `?edit=KEY`, a secret of its own; the session's id, which others look at by `?look=ID`, is a hash of it.
 *
 * It also passes calls of agents (`@farol/mcp`) to the page whose user allows them, and the results back. Such a page opens
 * the socket with `?allow`; the last one has the agents. An agent opens it with `?agent` and `agentKey` in a header, which
 * no page can send.
 */
export class LiveRelay {
  /** @type {Map<string, Session>} */
  sessions = new Map();
  /** Problems of messages that were dropped, for the terminal. @type {(problem: string) => void} */
  onProblem = () => {};
  /** Page whose user lets agents edit; null for none. @type {import('ws').WebSocket | null} */
  allowing = null;
  /** Agents by number. @type {Map<number, import('ws').WebSocket>} */
  agents = new Map();

  /** @param {string} [agentKey] - secret of the agents; none is let in when absent */
  constructor(agentKey) {
    this.agentKey = agentKey;
    const options = { noServer: true, perMessageDeflate: false };
    this.editors = new WebSocketServer({ ...options, maxPayload: liveLimits.edit });
    this.lookers = new WebSocketServer({ ...options, maxPayload: liveLimits.look });
    this.agentServer = new WebSocketServer({ ...options, maxPayload: liveLimits.agent });
    this.count = 0;
    /** Sockets that have not answered the last question. @type {WeakSet<import('ws').WebSocket>} */
    this.silent = new WeakSet();
    this.timer = setInterval(() => this.ask(), PING).unref();
  }

  /** @param {string} key */
  idOf(key) {
    return createHash('sha256').update(key).digest('hex').slice(0, 16);
  }

  /**
   * Opens a WebSocket for an editor, for a page that looks or for an agent. A page of another origin is refused, and so is an
   * agent of another machine or without the key.
   *
   * @param {import('node:http').IncomingMessage} request - let in already, see `networkGate`
   * @param {import('node:stream').Duplex} socket
   * @param {Buffer} head
   */
  upgrade(request, socket, head) {
    const { searchParams } = new URL(request.url ?? '/', 'http://host');
    const [key, look] = [searchParams.get('edit'), searchParams.get('look')];
    if (searchParams.has('agent')) return this.upgradeAgent(request, socket, head);
    const session = look === null ? null : this.sessions.get(look);
    if (!isOwnOrigin(request)) return refuse(socket, '403 Forbidden');
    if (searchParams.has('allow'))
      return this.editors.handleUpgrade(request, socket, head, (opened) => this.addAllowing(opened));
    if (key === null ? look === null : !/^[\w-]{22,64}$/.test(key)) return refuse(socket, '400 Bad Request');
    if (key !== null) this.editors.handleUpgrade(request, socket, head, (opened) => this.addEditor(key, opened));
    else if (session && session.looks.size >= liveLimits.looks) refuse(socket, '503 Service Unavailable');
    else
      this.lookers.handleUpgrade(request, socket, head, (opened) => this.addLook(/** @type {string} */ (look), opened));
  }

  /**
   * @param {import('node:http').IncomingMessage} request
   * @param {import('node:stream').Duplex} socket
   * @param {Buffer} head
   */
  upgradeAgent(request, socket, head) {
    const { origin, host, 'x-farol-agent': key } = request.headers;
    // a browser's request has an origin; one over HTTPS may come from another machine: see `serveToNetwork`
    const isHere = origin === undefined && !('encrypted' in request.socket) && isLocalHost(host);
    if (!isHere || !this.agentKey || !isSecret(String(key), this.agentKey)) return refuse(socket, '403 Forbidden');
    if (this.agents.size >= liveLimits.agents) return refuse(socket, '503 Service Unavailable');
    this.agentServer.handleUpgrade(request, socket, head, (opened) => this.addAgent(opened));
  }

  /**
   * Answers `GET /farol-live/ID/HASH` by an asset's bytes, and keeps those that the session's editor puts there.
   *
   * @param {import('node:http').IncomingMessage} request
   * @param {import('node:http').ServerResponse} response
   * @param {() => void} next
   */
  answer(request, response, next) {
    const [, id, hash] = new RegExp(`^${livePath}/([0-9a-f]{16})/([0-9a-f]{64})$`).exec(request.url ?? '') ?? [];
    if (!id) return next();
    const session = this.sessions.get(id);
    const end = (/** @type {number} */ status, /** @type {Buffer | string} */ body = '') =>
      void response.writeHead(status, { 'content-type': 'application/octet-stream' }).end(body);
    if (!session) return end(404);
    if (request.method === 'GET') {
      const bytes = session.assets.get(hash);
      return bytes ? end(200, bytes) : end(404);
    }
    const isEditor = isOwnOrigin(request) && this.idOf(String(request.headers['x-farol-key'])) === id;
    if (request.method !== 'PUT' || !isEditor) return end(403);
    /** @type {Buffer[]} */
    const parts = [];
    let size = [...session.assets.values()].reduce((sum, { length }) => sum + length, 0);
    let own = 0;
    request.on('data', (/** @type {Buffer} */ part) => {
      size += part.length;
      own += part.length;
      if (size <= liveLimits.assets && own <= liveLimits.asset) parts.push(part);
      else if (!response.writableEnded) end(413);
    });
    request.on('end', () => {
      if (response.writableEnded) return;
      const bytes = Buffer.concat(parts);
      if (createHash('sha256').update(bytes).digest('hex') !== hash) return end(400);
      session.assets.set(hash, bytes);
      end(200);
    });
  }

  close() {
    clearInterval(this.timer);
    for (const socket of this.sockets()) socket.terminate();
  }

  sockets() {
    return [...this.editors.clients, ...this.lookers.clients, ...this.agentServer.clients];
  }

  /** @param {string} id @returns {Session} */
  sessionOf(id) {
    const session = this.sessions.get(id) ?? { editor: null, looks: new Map(), assets: new Map() };
    this.sessions.set(id, session);
    return session;
  }

  /** @param {string} key @param {import('ws').WebSocket} socket */
  addEditor(key, socket) {
    const id = this.idOf(key);
    const session = this.sessionOf(id);
    session.editor?.close(4000, 'Another page edits.');
    session.editor = socket;
    this.listen(socket, 'edit', (message, text) => {
      const targets = typeof message.to === 'number' ? [session.looks.get(message.to)] : session.looks.values();
      for (const target of targets) if (target) pass(target, text);
    });
    socket.on('close', () => {
      if (session.editor !== socket) return;
      session.editor = null;
      for (const look of session.looks.values()) tell(look, { kind: 'away' });
      this.forget(id);
    });
    tell(socket, { kind: 'hello', id, looks: session.looks.size });
    for (const number of session.looks.keys()) tell(socket, { kind: 'join', number });
  }

  /** @param {string} id @param {import('ws').WebSocket} socket */
  addLook(id, socket) {
    const session = this.sessionOf(id);
    const number = ++this.count;
    session.looks.set(number, socket);
    const tellCount = () => session.editor && tell(session.editor, { kind: 'looks', looks: session.looks.size });
    this.listen(socket, 'look', () => session.editor && tell(session.editor, { kind: 'join', number }));
    socket.on('close', () => {
      session.looks.delete(number);
      tellCount();
      this.forget(id);
    });
    tellCount();
    if (session.editor) tell(session.editor, { kind: 'join', number });
    else tell(socket, { kind: 'away' });
  }

  /** @param {import('ws').WebSocket} socket */
  addAllowing(socket) {
    this.allowing?.close(4000, 'Another page lets agents edit.');
    this.allowing = socket;
    this.listen(socket, 'allow', (message, text) => {
      const agent = this.agents.get(Number(message.to));
      if (agent) pass(agent, text);
    });
    socket.on('close', () => {
      if (this.allowing !== socket) return;
      this.allowing = null;
      for (const agent of this.agents.values()) tell(agent, { kind: 'away' });
    });
    tell(socket, { kind: 'hello' });
    for (const agent of this.agents.values()) tell(agent, { kind: 'there' });
  }

  /** @param {import('ws').WebSocket} socket */
  addAgent(socket) {
    const number = ++this.count;
    this.agents.set(number, socket);
    this.listen(socket, 'agent', (message) => {
      if (this.allowing) tell(this.allowing, { ...message, number });
      else if (message.kind === 'call') tell(socket, { kind: 'away' });
    });
    socket.on('close', () => {
      this.agents.delete(number);
      if (this.allowing) tell(this.allowing, { kind: 'left', number });
    });
  }

  /** Drops a session that nobody edits and nobody looks at. @param {string} id */
  forget(id) {
    const session = this.sessions.get(id);
    if (session && !session.editor && session.looks.size === 0) this.sessions.delete(id);
  }

  /**
   * @param {import('ws').WebSocket} socket
   * @param {keyof typeof kinds} side
   * @param {(message: { kind: string, to?: unknown }, text: string) => void} take
   */
  listen(socket, side, take) {
    socket.on('pong', () => this.silent.delete(socket));
    // the socket closes itself after an error, such as a message over the limit
    socket.on('error', (error) => this.onProblem(`A message of a page was refused: ${error.message}`));
    socket.on('message', (data, isBinary) => {
      const text = String(data);
      const message = isBinary ? null : parse(text);
      if (message && kinds[side].includes(message.kind)) return take(message, text);
      const problem = message ? 'is of no kind that this page may send' : 'is no JSON object';
      this.onProblem(`A message that ${problem} was dropped: ${JSON.stringify(text.slice(0, 60))}`);
      tell(socket, { kind: 'problem', problem: `The message ${problem}.` });
    });
  }

  /** Ends sockets that did not answer, and asks the others. */
  ask() {
    for (const socket of this.sockets()) {
      if (this.silent.has(socket)) socket.terminate();
      else {
        this.silent.add(socket);
        socket.ping();
      }
    }
  }
}

/** @param {string} text @returns {{ kind: string, to?: unknown } | null} null for what is no JSON object */
function parse(text) {
  try {
    const message = JSON.parse(text);
    return typeof message === 'object' && message !== null ? message : null;
  } catch {
    return null;
  }
}

/** @param {import('ws').WebSocket} socket @param {object} message */
const tell = (socket, message) => pass(socket, JSON.stringify(message));

/** Sends a text; ends a socket with too much unsent. @param {import('ws').WebSocket} socket @param {string} text */
function pass(socket, text) {
  if (socket.bufferedAmount > liveLimits.unsent) socket.terminate();
  else socket.send(text, () => {});
}

/**
 * Whether a request comes from a page of this server. Without HTTPS, and so without the token, its host must be a name
 * of this machine: another name may lead here by DNS rebinding.
 *
 * @param {import('node:http').IncomingMessage} request
 */
export function isOwnOrigin({ headers: { origin, host = '' }, socket }) {
  if ('encrypted' in socket) return origin === `https://${host}`;
  return origin === `http://${host}` && isLocalHost(host);
}

/** Whether a request asks for this machine by its own name. @param {string | undefined} host */
const isLocalHost = (host = '') => /^(localhost|127\.0\.0\.1|\[::1\])(:\d+)?$/.test(host);

/** @param {import('node:stream').Duplex} socket @param {string} status */
export const refuse = (socket, status) => void socket.end(`HTTP/1.1 ${status}\r\nConnection: close\r\n\r\n`);
