import { readFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import type { EditorPlace } from './EditorLink';

/** File in which `npm start` stores its address and key, readable by this user alone. */
export const placeFile = (): string => join(homedir(), '.farol', 'agent.json');

const isLocal = (url: string): boolean => /^https?:\/\/(localhost|127\.0\.0\.1|\[::1\])(:\d+)?\//.test(url);

/**
 * Finds the dev server: by FAROL_AGENT_URL and FAROL_AGENT_KEY, else by the file of `npm start`.
 * @throws Error when neither exists, or the address is not of this machine
 */
export function findEditor(env: Readonly<Record<string, string | undefined>> = process.env): EditorPlace {
  const { FAROL_AGENT_URL: url, FAROL_AGENT_KEY: key } = env;
  const place = url && key ? { url, key } : readPlace();
  if (!isLocal(place.url))
    throw new Error(`${place.url} is not on this machine: a tunnel such as ssh -L brings it here`);
  return place;
}

function readPlace(): EditorPlace {
  let text: string;
  try {
    text = readFileSync(placeFile(), 'utf8');
  } catch {
    throw new Error(`no ${placeFile()}, which npm start writes`);
  }
  const { url, key } = JSON.parse(text) as Partial<EditorPlace>;
  if (typeof url !== 'string' || typeof key !== 'string') throw new Error(`${placeFile()} has no url and key`);
  return { url, key };
}
