import type { McpServer } from '@modelcontextprotocol/sdk/server/mcp.js';
import { StdioServerTransport } from '@modelcontextprotocol/sdk/server/stdio.js';
import { EditorLink } from './EditorLink';
import { findEditor } from './findEditor';
import { makeServer } from './makeServer';

const link = new EditorLink(() => findEditor());
/** Server of the command `farol-mcp`, on standard input and output. */
export const server: McpServer = makeServer(link);
await server.connect(new StdioServerTransport());
// a client that exits closes the input
process.stdin.once('end', () => process.exit(0));
