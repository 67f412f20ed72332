import type { Texts } from '@farol/editing';

/** Spanish texts of agents' edits, and of the bar and dialog that allow agents. */
export const agent: Texts = {
  'An agent may edit': 'Un agente puede editar',
  'none is connected yet': 'aún no hay ninguno conectado',
  '{names} may edit': '{names} puede editar',
  '{count} calls': '{count} llamadas',
  '{count} call': '{count} llamada',
  'End it': 'Terminar',
  'An agent': 'Un agente',
  'Let an agent edit': 'Dejar que un agente edite',
  'A program on this computer that speaks the Model Context Protocol may then read this scene and its messages, see its picture, edit it and run the commands of the menus. Each of its calls is one step that you can undo.':
    'Un programa de este equipo que hable el Model Context Protocol podrá leer la escena y sus mensajes, ver su imagen, editarla y ejecutar las órdenes de los menús. Cada una de sus llamadas es un paso que se puede deshacer.',
  'A bar is shown while agents may edit. Its button ends that, as does closing or reloading this tab.':
    'Una barra lo indica mientras dure. Termina con el botón de la barra y al cerrar o recargar esta pestaña.',
  'Setting of the MCP client': 'Ajuste del cliente MCP',
  Setting: 'Ajuste',
  'Allow it': 'Permitir',
  'Agents reach this page only where npm start serves it. Start the editor like this:':
    'Esta página no la sirve npm start, por donde entran los agentes. El editor se arranca así:',
  'Another tab lets an agent edit now, so this one does not any more.':
    'Ahora otra pestaña deja editar a un agente, así que esta ya no.',
  'The connection to the server was lost, so no agent can edit any more.':
    'Se perdió la conexión con el servidor, así que ningún agente puede editar ya.',
  '{client}: {count} edits': '{client}: {count} cambios',
  '{client}: {count} edit': '{client}: {count} cambio',
  '{client} added {name}': '{client} añadió {name}',
  '{client} deleted {name}': '{client} eliminó {name}',
  '{client} edited {name}': '{client} cambió {name}',
};
