"""The stubs name what the module has, with its arguments; everything public has a docstring."""

import ast
import inspect
import os
import unittest

from common import SOURCE

import fiberchain as fc

STUB = os.path.join(SOURCE, "compare", "python", "fiberchain", "__init__.pyi")


def arguments_of(node):
    every = node.args.posonlyargs + node.args.args + node.args.kwonlyargs
    names = [argument.arg for argument in every]
    for more in (node.args.vararg, node.args.kwarg):
        if more is not None:
            names.append(more.arg)
    return names


class Stubs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        with open(STUB) as file:
            body = ast.parse(file.read()).body
        cls.functions = {node.name: node for node in body if isinstance(node, ast.FunctionDef)}
        cls.classes = {node.name: node for node in body if isinstance(node, ast.ClassDef)
                       if not node.name.startswith("_")}

    def test_names(self):
        stubbed = set(self.functions) | set(self.classes) | {"commit"}
        self.assertEqual(stubbed, set(fc.__all__))

    def test_arguments_of_functions(self):
        for name, node in self.functions.items():
            real = list(inspect.signature(getattr(fc, name)).parameters)
            self.assertEqual(arguments_of(node), real, name)

    def test_members_of_classes(self):
        for name, node in self.classes.items():
            own = getattr(fc, name)
            if issubclass(own, tuple):
                continue
            members = {one.name for one in node.body if isinstance(one, ast.FunctionDef)}
            members |= {one.target.id for one in node.body if isinstance(one, ast.AnnAssign)}
            real = {member for member in dir(own) if not member.startswith("_")}
            real |= set(getattr(own, "__dataclass_fields__", {}))
            public = {member for member in members if not member.startswith("_")}
            self.assertEqual(public, real, name)
            for one in node.body:
                if isinstance(one, ast.FunctionDef) and inspect.isfunction(inspect.getattr_static(own, one.name, None)):
                    real_arguments = list(inspect.signature(getattr(own, one.name)).parameters)
                    self.assertEqual(arguments_of(one), real_arguments, f"{name}.{one.name}")

    def test_docstrings(self):
        for name in fc.__all__:
            if name == "commit":
                continue
            thing = getattr(fc, name)
            self.assertTrue(thing.__doc__, name)
            if not inspect.isclass(thing) or issubclass(thing, tuple):
                continue
            for member, value in inspect.getmembers(thing):
                if not member.startswith("_") and (callable(value) or isinstance(value, property)):
                    self.assertTrue(value.__doc__, f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
