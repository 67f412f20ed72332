import { z } from 'zod';

/** Maximum number of objects in one call, and of edits in a batch. */
export const MOST_EDITS = 200;

const finite = z.number();
// not a tuple: some clients only support the schema of plain arrays
const triple = (unit: string) => z.array(finite).length(3).describe(unit);

const object = z.string().min(1).max(400).describe('an object: its name, its path such as "Street/Lamp 3", or its id');

const objects = z.array(object).min(1).max(MOST_EDITS);

const value = z.union([z.number(), z.string().max(20_000), z.boolean(), z.null(), z.array(z.unknown()).max(64)]);

const values = z
  .record(z.string(), value)
  .describe("by field; angles in °, colours '#rrggbb' or linear [r, g, b]. describe_type has units and ranges");

const place = {
  position: triple('m, relative to the parent').optional(),
  rotation: triple('° about x, then y, then z').optional(),
  scale: triple('factors along x, y, z').optional(),
  lookAt: triple('world point (m) that its front, -Z, is turned to').optional(),
};

/** Edits of the scene: each is a tool, and can be part of a batch. */
export const edits = {
  add_object: {
    description: 'Adds an object. A light shines along -Z; spot lights point down unless they are turned.',
    input: {
      what: z
        .string()
        .max(200)
        .describe(
          'such as "empty", "box", "Point light"; of the library "Street lamp", "Tree", "Foggy night": see describe_type',
        ),
      name: z.string().min(1).max(200).optional(),
      parent: object.optional().describe('the top of the scene when absent'),
      ...place,
      components: z
        .record(z.string(), values)
        .optional()
        .describe('values of its components by type, such as {"Light": {"intensity": 40}}; missing ones are added'),
    },
  },
  set_fields: {
    description: 'Sets fields of a component, of the object itself, or of the scene (object "scene").',
    input: {
      object,
      component: z
        .string()
        .max(200)
        .optional()
        .describe('type, such as "Light"; "Object" for name, active, locked, static; not needed for "scene"'),
      values,
    },
  },
  add_component: {
    description: 'Adds a component to an object.',
    input: { object, component: z.string().max(200), values: values.optional() },
  },
  move_object: {
    description: 'Moves, turns, scales an object, or puts it below another parent, in this order: parent, place.',
    input: {
      object,
      parent: z.string().max(400).optional().describe('new parent, or "scene"; it stays where it is in the world'),
      ...place,
      by: triple('m, added to its position').optional(),
    },
  },
  duplicate_along: {
    description:
      'Copies objects along a line, on a ring, on a grid, or scattered over a surface. Originals are the first of them.',
    input: {
      objects,
      kind: z.enum(['line', 'ring', 'grid', 'scatter']),
      count: z.int().min(1).max(2000).optional().describe('objects in all, originals included; 5 when absent'),
      offset: triple('line: m from each to the next').optional(),
      radius: finite.min(0.001).optional().describe('ring: m'),
      arc: finite.min(-360).max(360).optional().describe('ring: ° that it covers; 360 when absent'),
      turns: z.boolean().optional().describe('ring: whether each is turned by its angle'),
      counts: z.array(z.int().min(1).max(200)).length(3).optional().describe('grid: objects along x, y, z'),
      spacing: triple('grid: m between them').optional(),
      surface: object.optional().describe('scatter: object whose surface they lie on'),
      distance: finite.min(0).optional().describe('scatter: least m between two'),
      follows: z.boolean().optional().describe('drop each on the surface below it'),
      height: finite.optional().describe('m above the surface'),
      seed: z.int().min(1).optional(),
      sizeVariation: finite.min(0).max(1).optional(),
      colours: z.enum(['same', 'random', 'rainbow']).optional().describe('of their lights'),
      intensityVariation: finite.min(0).max(1).optional(),
      sharesLight: z.boolean().optional().describe('whether all together are as bright as one; false when absent'),
      grouped: z.boolean().optional().describe('whether all go below a new object; false when absent'),
    },
  },
  delete: {
    description: 'Deletes objects with all below them, or a component of each.',
    input: { objects, component: z.string().max(200).optional().describe('type; the object itself when absent') },
  },
} as const;

type EditName = keyof typeof edits;
type InputOf<Shape extends z.ZodRawShape> = z.infer<z.ZodObject<Shape>>;

/** One edit of a batch: the name of a tool of `edits`, with its input. */
export type Edit = { [Name in EditName]: { edit: Name } & InputOf<(typeof edits)[Name]['input']> }[EditName];

const editNames = Object.keys(edits) as EditName[];
const anyEdit = z.discriminatedUnion(
  'edit',
  editNames.map((name) => z.strictObject({ edit: z.literal(name), ...edits[name].input })) as never,
) as unknown as z.ZodType<Edit>;

const reads = {
  get_scene: {
    description: 'The tree of the scene with ids, components, world positions; name, file, play state, undo.',
    input: {
      below: object.optional().describe('only what is below this object'),
      find: z.string().max(200).optional().describe('only objects whose name or component types contain this'),
      most: z.int().min(1).max(2000).optional().describe('lines; 200 when absent'),
    },
  },
  get_objects: {
    description: 'Values of all components of objects; object "scene" has the settings of the scene.',
    input: {
      objects,
      bounds: z.boolean().optional().describe('also unit and range of each field'),
    },
  },
  describe_type: {
    description:
      'JSON schema of the fields of a component type, of "scene" or "Object": unit, range, default, help. Without a type: what can be added, all types, samples.',
    input: { type: z.string().max(200).optional() },
  },
  get_lights: {
    description: 'All lights with type, place, colour, intensity, range, shadow, and how the picture is drawn.',
    input: {},
  },
  screenshot: {
    description:
      "The picture without the editor's marks: from the user's view, from a camera of the scene, or from a point.",
    input: {
      camera: object.optional().describe('object with a Camera'),
      from: triple('world point (m) to look from').optional(),
      to: triple('world point (m) to look at').optional(),
      fov: finite.min(1).max(170).optional().describe('vertical field of view (°), with from and to'),
      width: z.int().min(64).max(1920).optional().describe('pixels; 960 when absent'),
    },
  },
  get_messages: {
    description: 'Messages of the console, newest last, and the dialog that is open.',
    input: {
      least: z.enum(['info', 'warning', 'error']).optional().describe('least serious kind; info when absent'),
      most: z.int().min(1).max(500).optional().describe('50 when absent'),
    },
  },
  save_text: { description: 'The scene as the text of a scene file.', input: {} },
  list_actions: {
    description: "The editor's commands, as in its menus and keys: id, name, whether available now.",
    input: { find: z.string().max(200).optional().describe('only those whose id or name contains this') },
  },
};

const controls = {
  batch: {
    description: `Up to ${MOST_EDITS} edits in order, as one step to undo: all are made, or none. Later ones may name what earlier ones add.`,
    input: {
      label: z.string().min(1).max(80).optional().describe('name of the step in the history'),
      edits: z.array(anyEdit).min(1).max(MOST_EDITS),
    },
  },
  run_action: {
    description: 'Runs a command of list_actions, with these objects selected if given.',
    input: { id: z.string().max(200), objects: objects.optional() },
  },
  undo: {
    description: 'Takes back the last steps. Each call of a tool that edits is one step.',
    input: { steps: z.int().min(1).max(100).optional() },
  },
  redo: { description: 'Does undone steps again.', input: { steps: z.int().min(1).max(100).optional() } },
  open_scene: {
    description: 'Opens a new scene ("empty": camera, sun, sky) or a sample. The user is asked about unsaved changes.',
    input: { name: z.string().max(200).describe('"empty", or a sample of describe_type') },
  },
  play: {
    description:
      'Plays, pauses, steps (1/60 s) or stops the scene. Edits made while it plays are undone when it stops.',
    input: { do: z.enum(['play', 'pause', 'step', 'stop']) },
  },
};

/** All tools by name. */
export const tools = { ...reads, ...edits, ...controls };

export type ToolName = keyof typeof tools;

/** Input of a tool, once checked. */
export type ToolInput<Name extends ToolName> = InputOf<(typeof tools)[Name]['input']>;

/** Whether a tool only reads the scene. */
export const isReading = (name: ToolName): boolean => Object.hasOwn(reads, name);

/** Schema of a tool's input; unknown names are refused. */
export const inputSchema = (name: ToolName): z.ZodObject => z.strictObject(tools[name].input as z.ZodRawShape);

/**
 * Checks the input of a tool.
 * @throws Error that names tool and field, and what is allowed
 */
export function checkInput(name: string, input: unknown): { name: ToolName; input: unknown } {
  if (!Object.hasOwn(tools, name))
    throw new Error(`There is no tool “${name}”: there are ${Object.keys(tools).join(', ')}.`);
  const read = inputSchema(name as ToolName).safeParse(input);
  if (!read.success) {
    const problems = read.error.issues.map(({ path, message }) => `${path.join('.') || 'input'}: ${message}`);
    throw new Error(`${name} cannot take this. ${problems.slice(0, 5).join('; ')}.`);
  }
  return { name: name as ToolName, input: read.data };
}

/** A part of a tool's answer: text, or a picture (base64). */
export type Content =
  | { readonly type: 'text'; readonly text: string }
  | { readonly type: 'image'; readonly data: string; readonly mimeType: string };

/** Messages of an agent to the editor; the relay adds the agent's number. */
export type AgentMessage =
  | { readonly kind: 'name'; readonly name: string }
  | { readonly kind: 'call'; readonly id: number; readonly tool: string; readonly input: unknown };

/** Message of the editor to the agent that called. */
export interface ToolResult {
  readonly kind: 'result';
  /** Number of the agent. */
  readonly to: number;
  /** Id of the call. */
  readonly id: number;
  readonly content: readonly Content[];
  readonly isError?: boolean;
}
