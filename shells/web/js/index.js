// dogleaf for browsers: real paper for e-readers. `load` first; then a `BookView` on a canvas, or a `Book` of your own.
export { Book } from "./book.js";
export { BookRenderer } from "./renderer.js";
export { BookView } from "./view.js";
export { Dogleaf, hasVectors, load } from "./load.js";
export { DogleafError, bookOptions } from "./options.js";
