import type { Texts } from '@farol/editing';

/** Spanish texts of surfaces made of microshaders. */
export const surfaces: Texts = {
  'Play: waves, embers, rust and a hologram. Select a material in Assets, and move its values.':
    'Reproduce: olas, brasas, óxido y un holograma. Selecciona un material en Recursos y mueve sus valores.',
  'Phong, directional light': 'Phong, luz direccional',
  'Phong, point light': 'Phong, luz puntual',
  'Phong, spot light': 'Phong, foco',
  Waves: 'Olas',
  Water: 'Agua',
  Snow: 'Nieve',
  Moss: 'Musgo',
  Dissolve: 'Disolver',
  Rust: 'Óxido',
  Hologram: 'Holograma',
  'No surface': 'Ninguna superficie',
  'Drop {name} on an object with a mesh, which then gets it.':
    'Hay que soltar {name} sobre un objeto con malla, que lo recibe.',
  'Edited surface {name}': 'Superficie {name} editada',
  'Made surface {name}': 'Superficie {name} creada',
  'Made surface {name} for {objects}': 'Superficie {name} creada para {objects}',
  'New surface': 'Nueva superficie',
  'Edit its text': 'Editar su texto',
  'GLSL of the library that changes colour and shape, and its uniforms.':
    'GLSL de la biblioteca que cambia su aspecto y su forma, y los valores que pide.',
  surface: 'superficie',
  'Text of the surface': 'Texto de la superficie',
  'Show the asset': 'Mostrar el recurso',
  Uniforms: 'Uniforms',
  'None.': 'Ninguno.',
  'Nothing. Drag it from Assets onto an object.': 'Nada. Se arrastra de Recursos a un objeto.',
  'Own values of {surface}': 'Valores propios de {surface}',
  'Own values of {surface} for {objects}': 'Valores propios de {surface} para {objects}',
  'The values of the surface for this object alone; others of the material keep theirs':
    'Los valores de la superficie solo para este objeto; los demás del material conservan los suyos',
  'Waves, rust, snow and the like for this object alone, over the effect of its material. It has values of its own.':
    'Olas, óxido, nieve y similares solo para este objeto, sobre el efecto de su material. Tiene valores propios.',
  'On material': 'En el material',
  'The material of the model whose parts get the surface; all of them when none is chosen.':
    'El material del modelo cuyas partes llevan la superficie; todas si no se elige ninguno.',
  'It runs on the graphics card alone, and needs no permission. A loop without an end can stall the whole page.':
    'Solo se ejecuta en la tarjeta gráfica y no necesita permiso. Un bucle sin fin puede detener toda la página.',
  'The surface {surface} is left out': 'La superficie {surface} se omite',
  'Surface effect': 'Efecto de superficie',
  'Waves, rust, snow and the like: GLSL that changes look and shape.':
    'Olas, óxido, nieve y similares: GLSL que cambia el aspecto y la forma.',
  'Surface values': 'Valores de la superficie',
  'Values of the surface.': 'Los valores de la superficie.',
  'Surface texture': 'Textura de la superficie',
  'A texture of the surface.': 'Una textura de la superficie.',
  'Text: GLSL with surface() or displace(), and its uniforms.':
    'Texto: GLSL con surface() o displace(), y los uniforms que declara.',
};
