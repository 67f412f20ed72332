// Where the picture lies in the target.
// Farol
uniform vec2 farol_offset; // pixels
