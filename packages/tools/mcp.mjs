/**
 * The MCP server over the open editor (`@farol/mcp`), from source: for clients of the Model Context Protocol, which start it
 * by `node packages/tools/mcp.mjs` and talk to it by standard input and output.
 */
import { mkdirSync, mkdtempSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { build } from 'vite';
import { root } from './root.mjs';

const folder = join(root, 'packages/mcp');
mkdirSync(join(root, '.cache'), { recursive: true });
// of this process alone: clients may start several at once
const outDir = mkdtempSync(join(root, '.cache', 'mcp-'));
process.once('exit', () => rmSync(outDir, { recursive: true, force: true }));
// silent, since standard output is for messages of the protocol
await build({ root: folder, configFile: join(folder, 'vite.config.ts'), logLevel: 'silent', build: { outDir } });
await import(pathToFileURL(join(outDir, 'cli.js')).href);
