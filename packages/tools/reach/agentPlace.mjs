import { chmodSync, mkdirSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { dirname, join } from 'node:path';

/** File by which `@farol/mcp` finds the editor, as its `placeFile` says; who can read it can let an agent in. */
export const agentPlaceFile = () => join(homedir(), '.farol', 'agent.json');

/**
 * Notes, for this user alone, where the editor is served and by which key agents are let in. A home that cannot be written
 * is no reason not to start: agents then need FAROL_AGENT_URL and FAROL_AGENT_KEY.
 *
 * @param {string} url
 * @param {string} key
 */
export function noteAgentPlace(url, key) {
  const file = agentPlaceFile();
  try {
    mkdirSync(dirname(file), { recursive: true, mode: 0o700 });
    writeFileSync(file, JSON.stringify({ url, key }), { mode: 0o600 });
    // `mode` above holds only where writeFileSync makes the file anew
    chmodSync(file, 0o600);
  } catch (error) {
    console.warn(
      `  ${file} cannot be written, so agents do not find the editor: ${/** @type {Error} */ (error).message}`,
    );
  }
}
