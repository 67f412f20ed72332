#!/usr/bin/env node
import { StdioServerTransport } from '@modelcontextprotocol/sdk/server/stdio.js';
import { EditorLink } from './EditorLink';
import { findEditor } from './findEditor';
import { makeServer } from './makeServer';

const link = new EditorLink(() => findEditor());
await makeServer(link).connect(new StdioServerTransport());
// a client that goes without a word closes the input
process.stdin.once('end', () => process.exit(0));
