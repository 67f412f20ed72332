/** The editor of Farol as an MCP server, for hosts with a transport of their own. */
export { type Answer, EditorLink, type EditorPlace } from './EditorLink';
export { findEditor } from './findEditor';
export { makeServer } from './makeServer';
export { type Content, isReading, type ToolName, tools } from './tools';
